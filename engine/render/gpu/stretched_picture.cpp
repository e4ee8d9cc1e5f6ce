// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/gpu/stretched_picture.h"

#include <epoxy/gl.h>

namespace patina {
namespace {

void stretch(unsigned from, glm::ivec2 size, unsigned to, glm::ivec2 newSize) {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, from);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, to);
    glBlitFramebuffer(0, 0, size.x, size.y, 0, 0, newSize.x, newSize.y, GL_COLOR_BUFFER_BIT,
                      size == newSize ? GL_NEAREST : GL_LINEAR);
    glBindFramebuffer(GL_FRAMEBUFFER, to);
}

} // namespace

StretchedPicture::StretchedPicture(glm::ivec2 size)
    : size_(size), image_(gl::Texture::create(size, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE)),
      kept_(gl::Framebuffer::create()) {
    kept_.attachColor(image_);
}

void StretchedPicture::take(unsigned framebuffer) {
    stretch(framebuffer, size_, kept_.name(), size_);
}

void StretchedPicture::show(unsigned framebuffer, glm::ivec2 size) const {
    stretch(kept_.name(), size_, framebuffer, size);
}

} // namespace patina
