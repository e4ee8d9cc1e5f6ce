// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/gpu/stretched_picture.h"

#include <cmath>

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

void StretchedPicture::read(unsigned char* pixels) const {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, kept_.name());
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, size_.x, size_.y, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
}

void StretchedPicture::show(unsigned framebuffer, glm::ivec2 size) const {
    stretch(kept_.name(), size_, framebuffer, size);
}

Checked<void> StretchedPicture::draw(const ScreenTarget& target, const Catalog& catalog,
                                     ProgramCache& cache) const {
    return drawPicture(image_, wholePicture(target), target, false, catalog, cache);
}

/// Moves by whole pixels of the target, so that a picture of the same height stays sharp.
Checked<void> StretchedPicture::drawUndistorted(const ScreenTarget& target, const Catalog& catalog,
                                                ProgramCache& cache) const {
    const double scale = double(target.size.y) / size_.y;
    const double beside = std::floor((target.size.x - scale * size_.x) / 2.0);
    PicturePart part = wholePicture(target);
    part.scale.x = static_cast<float>(1.0 / (scale * size_.x));
    part.offset.x = static_cast<float>(-beside / (scale * size_.x));
    return drawPicture(image_, part, target, false, catalog, cache);
}

} // namespace patina
