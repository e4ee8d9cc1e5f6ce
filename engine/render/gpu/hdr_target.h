// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec2.hpp>

#include "core/error.h"
#include "gl/framebuffer.h"
#include "render/gpu/hdr_numbers.h"
#include "render/gpu/pixel_sampling.h"

namespace patina {

/// Tells whether the device of the current context draws pictures of this size; else the sizes it
/// does.
Result<void> checkPictureSize(glm::ivec2 size);

/// Is where a frame is summed up: RGBA16F (or RGBA32F) with several samples per pixel and depth,
/// and its resolved image, which may be drawn smaller than it is and stretched.
class HdrTarget {
  public:
    /// Makes the target fit; nothing happens when it does already. Fewer samples are used where
    /// the driver offers fewer. True where it was made anew. The error says which sizes are
    /// possible.
    ///
    /// `dense`: there are more triangles than pixels. Then each sample is a pixel of a finer image
    /// instead of a share of one that is shaded once (MSAA): hardly two samples belong to the same
    /// triangle, so this shades no more often, shades each at its own place, and spares software
    /// drivers the sorting of samples, which takes them twice as long.
    ///
    /// `scale`: as much of the size, along each side, is drawn and then stretched; 0 .. 1.
    ///
    /// With one sample per pixel the averaged image is what is drawn into: it is in memory once and
    /// resolve() copies nothing. `isReadBetween`: it is read while there is more to draw, and so
    /// has to be another one.
    Result<bool> fit(glm::ivec2 size, int samples, bool dense,
                     HdrNumbers numbers = HdrNumbers::Half, double scale = 1.0,
                     bool isReadBetween = false);

    /// Binds it for drawing, with its whole area as the viewport.
    void bind() const;

    /// Returns the size of the image that is drawn.
    glm::ivec2 drawnSize() const { return built_.fineness * built_.scaled; }

    /// Returns what the device made of what was asked for.
    PixelSampling sampling() const;

    /// Averages the samples into averaged(): what has been drawn until now, not yet stretched.
    void resolve() const;
    const gl::Texture& averaged() const { return resolvedImage_; }
    glm::ivec2 averagedSize() const { return built_.scaled; }

    /// Stretches what resolve() has averaged to the resolved image, where it is smaller.
    void stretch() const;

    /// Returns how wide a pixel that is drawn is in pixels of the resolved image.
    double pixelWidth() const { return double(built_.size.x) / drawnSize().x; }

    /// Returns what is drawn into: its framebuffer and the depths in it.
    unsigned framebuffer() const { return framebuffer_.name(); }
    const gl::Renderbuffer& depth() const { return depth_; }

    const gl::Texture& resolved() const {
        return built_.isStretched() ? stretchedImage_ : resolvedImage_;
    }
    unsigned resolvedFramebuffer() const {
        return (built_.isStretched() ? stretchedFramebuffer_ : resolvedFramebuffer_).name();
    }

  private:
    struct Shape {
        glm::ivec2 size{0};
        glm::ivec2 scaled{0}; ///< before it is stretched
        int samples = 0;      ///< per pixel of the image that is drawn
        int fineness = 1;     ///< that image's pixels per side of one before it is stretched
        HdrNumbers numbers = HdrNumbers::Half;
        bool isReadBetween = false;

        bool isAveraged() const { return samples > 1 || fineness > 1 || isReadBetween; }
        bool isStretched() const { return scaled != size; }
        friend bool operator==(const Shape&, const Shape&) = default;
    };

    Result<void> build(const Shape& shape);
    Result<void> buildStretched();
    void attachAll();

    Shape wanted_;
    Shape built_;
    gl::Renderbuffer color_;
    gl::Renderbuffer depth_;
    gl::Framebuffer framebuffer_;
    gl::Texture resolvedImage_;
    gl::Framebuffer resolvedFramebuffer_;
    gl::Texture stretchedImage_;
    gl::Framebuffer stretchedFramebuffer_;
};

} // namespace patina
