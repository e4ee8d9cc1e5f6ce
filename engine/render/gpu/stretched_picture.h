// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec2.hpp>

#include "gl/framebuffer.h"
#include "gl/texture.h"
#include "render/gpu/screen_picture.h"

namespace patina {

/// Keeps a finished picture, which is shown stretched while one of another size is not drawn yet.
/// All calls need the same context to be current.
class StretchedPicture {
  public:
    explicit StretchedPicture(glm::ivec2 size);

    glm::ivec2 size() const { return size_; }

    /// Returns the framebuffer that holds the picture; it may be drawn into.
    unsigned framebuffer() const { return kept_.name(); }

    /// Copies the picture from a framebuffer of the same size.
    void take(unsigned framebuffer);

    /// Reads the picture into `pixels`, as many as size() has: rows from the bottom, 4 bytes of
    /// red, green, blue and opacity.
    void read(unsigned char* pixels) const;

    /// Draws the picture, stretched, into a framebuffer of `size` pixels and leaves that bound.
    void show(unsigned framebuffer, glm::ivec2 size) const;

    /// Does the same as show() by a program, since drivers that draw on the CPU keep what they
    /// compile of it and compile what show() takes for each context anew. An error says why there
    /// is none.
    Checked<void> draw(const ScreenTarget& target, const Catalog& catalog,
                       ProgramCache& cache) const;

    /// Draws it so, as high as the target and in its own aspect, as a view that gets wider or
    /// narrower shows a scene: cut off at the sides, or with its edges drawn out.
    Checked<void> drawUndistorted(const ScreenTarget& target, const Catalog& catalog,
                                  ProgramCache& cache) const;

  private:
    glm::ivec2 size_;
    gl::Texture image_;
    gl::Framebuffer kept_;
};

} // namespace patina
