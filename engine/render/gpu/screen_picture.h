// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec2.hpp>

#include "catalog/catalog.h"
#include "gl/texture.h"
#include "shading/program/program_cache.h"

namespace patina {

/// Names a framebuffer object of the current context, 0 for its window, and its size in pixels.
struct ScreenTarget {
    unsigned framebuffer = 0;
    glm::ivec2 size{0};
};

/// Says where a picture is read: at a pixel's place times `scale` plus `offset`, from 0 to 1 in the
/// picture. Beyond it there are its edges.
struct PicturePart {
    glm::vec2 scale{1.0f};
    glm::vec2 offset{0.0f};
};

/// Returns all of a picture, stretched to the target.
PicturePart wholePicture(const ScreenTarget& target);

/// Draws a part of a texture over all of `target` and leaves the framebuffer bound. `isBlended`:
/// colours that are multiplied by their opacity are blended with what is there. An error says why
/// there is no program.
Checked<void> drawPicture(const gl::Texture& picture, const PicturePart& part,
                          const ScreenTarget& target, bool isBlended, const Catalog& catalog,
                          ProgramCache& cache);

/// Keeps a picture that is laid over another one, as lines and handles are over a view's.
class OverlayPicture {
  public:
    /// Takes the pixels: rows from the top, 4 bytes of blue, green, red and opacity, the colours
    /// multiplied by it. Null: there is nothing to lay over.
    void take(glm::ivec2 size, const unsigned char* pixels);

    bool isEmpty() const { return image_.name() == 0; }

    /// Draws it as drawPicture() does.
    Checked<void> draw(const ScreenTarget& target, const Catalog& catalog,
                       ProgramCache& cache) const;

  private:
    gl::Texture image_;
};

} // namespace patina
