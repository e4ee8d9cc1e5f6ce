// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec2.hpp>

#include "core/error.h"
#include "gl/framebuffer.h"
#include "render/gpu/hdr_numbers.h"
#include "render/gpu/pixel_sampling.h"

namespace patina {

/// Succeeds when the device of the current context can draw pictures of this size, in pixels; the
/// error says which sizes it can draw.
Result<void> checkPictureSize(glm::ivec2 size);

/// Owns the images that a frame is drawn into: RGBA16F (or RGBA32F) with depth and several samples
/// per pixel, and the resolved image. The frame may be drawn smaller and then stretched to the
/// resolved image.
class HdrTarget {
  public:
    /// Allocates the images unless they fit already, and returns true where it did. Fewer samples
    /// are used where the driver offers fewer. The error says which sizes are possible, or that
    /// memory is too small.
    ///
    /// `dense` says that there are more triangles than pixels. Then each sample is a pixel of a
    /// finer image instead of a part of a pixel that is shaded once (MSAA). Two samples hardly ever
    /// belong to the same triangle, so this shades no more often, and software drivers need not
    /// sort samples, which takes them twice as long.
    ///
    /// `scale`, 0 .. 1, is the fraction of each side that is drawn and then stretched.
    ///
    /// With one sample per pixel the frame is drawn into the averaged image itself, so that
    /// resolve() copies nothing. `isReadBetween` says that the averaged image is read while there
    /// is more to draw, which needs a second image.
    Result<bool> fit(glm::ivec2 size, int samples, bool dense,
                     HdrNumbers numbers = HdrNumbers::Half, double scale = 1.0,
                     bool isReadBetween = false);

    /// Binds it for drawing, with its whole area as the viewport.
    void bind() const;

    /// Returns the size of the image that is drawn, in its own pixels or samples.
    glm::ivec2 drawnSize() const { return built_.fineness * built_.scaled; }

    /// Returns the samples that the device really has, which may be fewer than fit() asked for.
    PixelSampling sampling() const;

    /// Averages the samples drawn so far into averaged(), which is not stretched.
    void resolve() const;
    const gl::Texture& averaged() const { return resolvedImage_; }
    glm::ivec2 averagedSize() const { return built_.scaled; }

    /// Stretches averaged() to the resolved image; does nothing where both have one size.
    void stretch() const;

    /// Frees all but resolved(); the next fit() makes the rest again.
    void keepResolved();

    /// Returns how wide a pixel that is drawn is in pixels of the resolved image.
    double pixelWidth() const { return double(built_.size.x) / drawnSize().x; }

    /// Returns the framebuffer that is drawn into; depth() is attached to it.
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
        glm::ivec2 scaled{0}; ///< is the size before stretching
        int samples = 0;      ///< counts per pixel of the image that is drawn
        int fineness = 1;     ///< is the drawn image's pixels per side of an averaged pixel, 1 or 2
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
