// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/pass/frame_gpu.h"

#include <epoxy/gl.h>

namespace patina {

/// Calls a frame dense when it has more triangles than pixels.
Result<bool> FrameGpu::fitTarget(const FramePlan& plan, bool isReadBetween) {
    const PictureAccuracy& accuracy = plan.scene->accuracy;
    const View& view = *plan.view;
    const double scale = accuracy.scale();
    const double pixels = scale * view.size.x * (scale * view.size.y);
    const HdrNumbers numbers = accuracy.hasWholeNumbers() ? HdrNumbers::Full : view.numbers;
    const int samples = view.samples > 0 ? view.samples : accuracy.samples();
    return target().fit(view.size, samples, static_cast<double>(plan.triangles) > pixels, numbers,
                        scale, isReadBetween);
}

void FrameGpu::beginObjects() {
    target().bind();
    data.bind();
    environment.bind();
    glEnable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glDisable(GL_DITHER);
    shadows.bind();
}

void FrameGpu::endObjects() {
    setBlendState(BlendState::Opaque);
}

const gl::Texture& FrameGpu::picture() {
    return environment.hasPicture() ? environment.picture() : target().resolved();
}

unsigned FrameGpu::pictureFramebuffer() {
    return environment.hasPicture() ? environment.framebuffer() : target().resolvedFramebuffer();
}

void setBlendState(BlendState state) {
    const GLboolean colours = state == BlendState::Depths ? GL_FALSE : GL_TRUE;
    glColorMask(colours, colours, colours, colours);
    glDepthFunc(state == BlendState::Blended ? GL_LEQUAL : GL_LESS);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    (state == BlendState::Blended ? glEnable : glDisable)(GL_BLEND);
}

void leaveState() {
    glBindVertexArray(0);
    glUseProgram(0);
    glBindTexture(GL_TEXTURE_2D, 0);
    glDepthFunc(GL_LESS);
}

} // namespace patina
