// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/framebuffer.h"

#include <array>
#include <cassert>

#include <epoxy/gl.h>
#include <fmt/format.h>

namespace patina::gl {

void deleteFramebuffer(unsigned name) {
    glDeleteFramebuffers(1, &name);
}

unsigned colorAttachment(std::size_t location) {
    return GL_COLOR_ATTACHMENT0 + static_cast<unsigned>(location);
}

unsigned colorTextureOf(unsigned framebuffer) {
    GLint type = GL_NONE;
    GLint name = 0;
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
    glGetFramebufferAttachmentParameteriv(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0,
                                          GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, &type);
    if (type == GL_TEXTURE) {
        glGetFramebufferAttachmentParameteriv(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0,
                                              GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME, &name);
    }
    return static_cast<unsigned>(name);
}

Framebuffer Framebuffer::create() {
    Framebuffer framebuffer;
    GLuint name = 0;
    glGenFramebuffers(1, &name);
    framebuffer.name_ = Name<deleteFramebuffer>(name);
    return framebuffer;
}

void Framebuffer::attachColor(const Texture& texture) {
    attachColor(texture.name());
}

void Framebuffer::attachColor(unsigned texture) {
    glBindFramebuffer(GL_FRAMEBUFFER, name());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
}

void Framebuffer::attachColor(const Renderbuffer& buffer) {
    glBindFramebuffer(GL_FRAMEBUFFER, name());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, buffer.name());
}

void Framebuffer::attachDepth(const Renderbuffer& buffer) {
    glBindFramebuffer(GL_FRAMEBUFFER, name());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, buffer.name());
}

void Framebuffer::attachColor(const TargetTexture& texture, unsigned location) {
    static constexpr std::array<GLenum, 2> locations{GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    assert(location < locations.size());
    glBindFramebuffer(GL_FRAMEBUFFER, name());
    glFramebufferTexture2D(GL_FRAMEBUFFER, locations[location], texture.target(), texture.name(),
                           0);
    glDrawBuffers(static_cast<GLsizei>(location + 1), locations.data());
}

void Framebuffer::attachDepth(const TargetTexture& texture, int level) {
    glBindFramebuffer(GL_FRAMEBUFFER, name());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, texture.target(), texture.name(),
                           level);
}

void Framebuffer::attachColors(const TextureArray& texture) {
    glBindFramebuffer(GL_FRAMEBUFFER, name());
    std::array<GLenum, 8> locations{};
    assert(static_cast<std::size_t>(texture.layers()) <= locations.size());
    for (int layer = 0; layer < texture.layers(); ++layer) {
        locations[static_cast<std::size_t>(layer)] =
            colorAttachment(static_cast<std::size_t>(layer));
        glFramebufferTextureLayer(GL_FRAMEBUFFER, locations[static_cast<std::size_t>(layer)],
                                  texture.name(), 0, layer);
    }
    glDrawBuffers(texture.layers(), locations.data());
}

void Framebuffer::attachDepth(const TextureArray& texture, int layer) {
    glBindFramebuffer(GL_FRAMEBUFFER, name());
    glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, texture.name(), 0, layer);
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
}

Result<void> Framebuffer::check() const {
    glBindFramebuffer(GL_FRAMEBUFFER, name());
    const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
    if (status == GL_FRAMEBUFFER_COMPLETE) {
        return {};
    }
    return failure(
        fmt::format("the graphics driver cannot draw to this image format (0x{:x})", status));
}

} // namespace patina::gl
