// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/lights/blurred_environment.h"

#include <cmath>

#include <epoxy/gl.h>

namespace patina {
namespace {

constexpr int width = 128;
constexpr double finestKappa = 4096.0;

/// What a texel of the finest level blurs: it is a box of 90 / 128 degrees a side, whose variance
/// along either axis, a twelfth of the square of that in radians, is 1 / kappa.
constexpr double texelKappa = 80000.0;

/// Returns how far a level is out of focus: kappa falls to a quarter from one to the next.
double kappaOf(int level) {
    return finestKappa / std::pow(4.0, level);
}

} // namespace

void BlurredEnvironment::drawLevel(const gl::Program& program, int level) {
    const int size = map_.width() >> level;
    glViewport(0, 0, size, size);
    glUniform1f(program.uniform("faceTexels"), static_cast<float>(size));
    for (int face = 0; face < 6; ++face) {
        glUniform1i(program.uniform("cubeFace"), face);
        framebuffer_.attachColor(map_, face, level);
        glDrawArrays(GL_TRIANGLES, 0, 3);
    }
}

void BlurredEnvironment::draw(const gl::Program& faces, const gl::Program& blur) {
    if (!isThere()) {
        map_ = gl::CubeMap::create(width, GL_RGBA16F);
        framebuffer_ = gl::Framebuffer::create();
    }
    for (const GLenum state : {GL_DEPTH_TEST, GL_BLEND, GL_DITHER, GL_CULL_FACE}) {
        glDisable(state);
    }
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    noVertices_.bind();
    faces.use();
    drawLevel(faces, 0);
    blur.use();
    blur.bindSampler("environmentBlurred", 0);
    map_.bind(0);
    double last = texelKappa;
    for (int level = 0; level + 1 < map_.levels(); ++level) {
        const double kappa = kappaOf(level + 1);
        map_.showLevels(level, level);
        map_.bind(0);
        // Variances add up: 1 / kappa is that of each level.
        glUniform1f(blur.uniform("addedKappa"),
                    static_cast<float>(1.0 / (1.0 / kappa - 1.0 / last)));
        drawLevel(blur, level + 1);
        last = kappa;
    }
    map_.showLevels(0, map_.levels() - 1);
    glBindVertexArray(0);
}

} // namespace patina
