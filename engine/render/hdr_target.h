// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec2.hpp>

#include "core/error.h"
#include "gl/framebuffer.h"
#include "render/hdr_numbers.h"

namespace patina {

/// Where a frame is summed up: RGBA16F (or RGBA32F) with several samples per pixel and depth, and
/// its resolved image.
class HdrTarget {
  public:
    /// Makes the target fit; nothing happens when it does already. Fewer samples are used where
    /// the driver offers fewer. The error says which sizes are possible.
    ///
    /// `dense`: there are more triangles than pixels. Then each sample is a pixel of a finer image
    /// instead of a share of one that is shaded once (MSAA): hardly two samples belong to the same
    /// triangle, so this shades no more often, shades each at its own place, and spares software
    /// drivers the sorting of samples, which takes them twice as long.
    Result<void> fit(glm::ivec2 size, int samples, bool dense,
                     HdrNumbers numbers = HdrNumbers::Half);

    /// Binds it for drawing, with its whole area as the viewport.
    void bind() const;

    /// The size of the image that is drawn.
    glm::ivec2 drawnSize() const { return built_.fineness * built_.size; }

    /// Averages the samples into the resolved image.
    void resolve() const;

    /// Pixels of the image that is drawn per side of a resolved one.
    int fineness() const { return built_.fineness; }

    /// What is drawn into: its framebuffer and the depths in it.
    unsigned framebuffer() const { return framebuffer_.name(); }
    const gl::Renderbuffer& depth() const { return depth_; }

    const gl::Texture& resolved() const { return resolvedImage_; }
    unsigned resolvedFramebuffer() const { return resolvedFramebuffer_.name(); }

  private:
    struct Shape {
        glm::ivec2 size{0};
        int samples = 0;  ///< per pixel of the image that is drawn
        int fineness = 1; ///< that image's pixels per side of a resolved one
        HdrNumbers numbers = HdrNumbers::Half;
        friend bool operator==(const Shape&, const Shape&) = default;
    };

    Result<void> build(const Shape& shape);

    Shape wanted_;
    Shape built_;
    gl::Renderbuffer color_;
    gl::Renderbuffer depth_;
    gl::Framebuffer framebuffer_;
    gl::Texture resolvedImage_;
    gl::Framebuffer resolvedFramebuffer_;
};

} // namespace patina
