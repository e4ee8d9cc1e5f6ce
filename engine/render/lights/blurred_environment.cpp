// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/lights/blurred_environment.h"

#include <cmath>
#include <numbers>

#include <epoxy/gl.h>

#include "gl/driver.h"
#include "shading/effects/environment_effect.h"

namespace patina {
namespace {

using Layout = OctahedralLayout;

/// Is the kappa of the blur by a texel of level 0: its box has a variance along either axis, a
/// twelfth of its area in steradians, of 1 / kappa.
constexpr double texelKappa = 12.0 * Layout::texels * Layout::texels / (4.0 * std::numbers::pi);

/// Returns the concentration kappa of a level's lobe, which falls to a quarter from one level to
/// the next.
double kappaOf(int level) {
    return level == 0 ? texelKappa : std::exp2(Layout::log2Kappa - 2.0 * level);
}

/// Returns the length of the mean direction of a lobe, coth(kappa) - 1 / kappa; 0 .. 1.
double meanOf(double kappa) {
    return kappa > 20.0 ? 1.0 - 1.0 / kappa : 1.0 / std::tanh(kappa) - 1.0 / kappa;
}

/// Returns the kappa of the lobe that turns a lobe of kappa `from` into one of `to` by convolution.
/// It is found by bisection, since the lengths of the mean directions multiply.
double kappaBetween(double from, double to) {
    const double wanted = meanOf(to) / meanOf(from);
    double low = 0.0; // of log2
    double high = 40.0;
    for (int i = 0; i < 50; ++i) {
        const double middle = 0.5 * (low + high);
        (meanOf(std::exp2(middle)) < wanted ? low : high) = middle;
    }
    return std::exp2(low);
}

int widthOf(int level) {
    return Layout::texels >> level;
}

/// Returns the lower left texel of a level in levels_, as octahedralOrigin() in the shaders does.
glm::ivec2 originOf(int level) {
    return level == 0 ? glm::ivec2(0)
                      : glm::ivec2(Layout::texels, Layout::texels - widthOf(level - 1));
}

} // namespace

void BlurredEnvironment::makeRoom() {
    if (isThere()) {
        return;
    }
    // A software driver reads half floats more slowly, and a GPU whole ones.
    const GLenum format = gl::isSoftware() ? GL_RGBA32F : GL_RGBA16F;
    levels_ =
        gl::Texture::create({Layout::texels * 3 / 2, Layout::texels}, format, GL_RGBA, GL_FLOAT);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    drawn_ = gl::Texture::create(glm::ivec2(Layout::texels), format, GL_RGBA, GL_FLOAT);
    framebuffer_ = gl::Framebuffer::create();
    framebuffer_.attachColor(drawn_);
}

/// Draws a square with the program in use, and copies it to its place among the levels, since
/// nothing can be drawn to a texture that it is made from.
void BlurredEnvironment::drawAt(glm::ivec2 origin, int width) {
    glViewport(0, 0, width, width);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindTexture(GL_TEXTURE_2D, levels_.name());
    glCopyTexSubImage2D(GL_TEXTURE_2D, 0, origin.x, origin.y, 0, 0, width, width);
    glBindTexture(GL_TEXTURE_2D, 0);
}

void BlurredEnvironment::draw(const gl::Program& sharp, const gl::Program& matte,
                              const gl::Program& blur) {
    makeRoom();
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    for (const GLenum state : {GL_DEPTH_TEST, GL_BLEND, GL_DITHER, GL_CULL_FACE}) {
        glDisable(state);
    }
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    noVertices_.bind();
    sharp.use();
    drawAt(originOf(0), widthOf(0));
    matte.use();
    drawAt(Layout::matteOrigin, Layout::matteTexels);
    blur.use();
    blur.bindSampler("environmentBlurred", 0);
    for (int level = 1; level < Layout::levels; ++level) {
        bind(0);
        glUniform1f(blur.uniform("finerShare"), std::exp2(1.0f - static_cast<float>(level)));
        glUniform1f(blur.uniform("addedKappa"),
                    static_cast<float>(kappaBetween(kappaOf(level - 1), kappaOf(level))));
        drawAt(originOf(level), widthOf(level));
    }
    glBindVertexArray(0);
}

void BlurredEnvironment::bind(unsigned unit) const {
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(GL_TEXTURE_2D, levels_.name());
    glActiveTexture(GL_TEXTURE0);
}

} // namespace patina
