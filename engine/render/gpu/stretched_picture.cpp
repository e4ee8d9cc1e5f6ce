// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/gpu/stretched_picture.h"

#include <algorithm>
#include <cmath>

#include <epoxy/gl.h>

namespace patina {
namespace {

/// Draws the columns from.x .. from.y of a picture, without the last, to those of another one.
void stretchColumns(glm::ivec2 from, int height, glm::ivec2 to, int newHeight, GLenum filter) {
    glBlitFramebuffer(from.x, 0, from.y, height, to.x, 0, to.y, newHeight, GL_COLOR_BUFFER_BIT,
                      filter);
}

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

void StretchedPicture::showUndistorted(unsigned framebuffer, glm::ivec2 size) const {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, kept_.name());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
    const double scale = double(size.y) / size_.y;
    const int seen = std::clamp(int(std::lround(size.x / scale)), 1, size_.x);
    const int covered = std::clamp(int(std::lround(seen * scale)), 1, size.x);
    const int first = (size_.x - seen) / 2;
    const int left = (size.x - covered) / 2;
    const int right = left + covered;
    stretchColumns({first, first + seen}, size_.y, {left, right}, size.y, GL_LINEAR);
    if (covered < size.x) { // one column each, which a linear filter would blend with the next
        stretchColumns({0, 1}, size_.y, {0, left}, size.y, GL_NEAREST);
        stretchColumns({size_.x - 1, size_.x}, size_.y, {right, size.x}, size.y, GL_NEAREST);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
}

Checked<void> StretchedPicture::draw(const ScreenTarget& target, const Catalog& catalog,
                                     ProgramCache& cache) const {
    return drawPicture(image_, "passes/stretched.frag", target, false, catalog, cache);
}

} // namespace patina
