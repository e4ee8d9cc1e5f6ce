// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/surfaces/probe_target.h"

#include <epoxy/gl.h>

namespace patina {
namespace {

constexpr glm::ivec2 side{2, 2};

} // namespace

Result<ProbeTarget> ProbeTarget::create() {
    ProbeTarget target;
    target.depth_ = gl::Renderbuffer::create(side, GL_DEPTH_COMPONENT32F);
    target.framebuffer_ = gl::Framebuffer::create();
    target.framebuffer_.attachDepth(target.depth_);
    std::array<GLenum, inspectionOutputs> outputs{};
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        target.colors_[i] = gl::Texture::create(side, GL_RGBA32F, GL_RGBA, GL_FLOAT);
        outputs[i] = gl::colorAttachment(i);
        glFramebufferTexture2D(GL_FRAMEBUFFER, outputs[i], GL_TEXTURE_2D, target.colors_[i].name(),
                               0);
    }
    glDrawBuffers(inspectionOutputs, outputs.data());
    if (auto drawable = target.framebuffer_.check(); !drawable) {
        return tl::unexpected(drawable.error());
    }
    return target;
}

void ProbeTarget::begin(glm::ivec2 size, glm::ivec2 pixel) const {
    const glm::ivec2 corner = pixel / side * side;
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    glViewport(-corner.x, -corner.y, size.x, size.y);
    glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    glDepthMask(GL_TRUE);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

ProbeTarget::Outputs ProbeTarget::read(glm::ivec2 pixel) const {
    Outputs outputs{};
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.name());
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        glReadBuffer(gl::colorAttachment(i));
        glReadPixels(pixel.x % side.x, pixel.y % side.y, 1, 1, GL_RGBA, GL_FLOAT, &outputs[i]);
    }
    return outputs;
}

} // namespace patina
