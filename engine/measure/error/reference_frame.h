// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <memory>
#include <vector>

#include "measure/error/linear_frame.h"
#include "measure/error/surface_code.h"

namespace patina {

/// Represents a frame computed on the CPU in double precision, from what its programs know of each
/// pixel. Works in steps, on all cores; who wants it no more stops asking. Needs no OpenGL.
class ReferenceFrame {
  public:
    /// `wanted`, by object of the scene: whose pixels count. The error says why one of them cannot
    /// be computed so.
    static Result<std::unique_ptr<ReferenceFrame>> create(SurfaceBuffer buffer,
                                                          const std::vector<bool>& wanted);

    /// Works for about so long; true when all is done.
    bool step(std::chrono::milliseconds patience);
    double progress() const; ///< 0 .. 1, of what was given so far

    /// The frame that is done becomes the mean of it and of one with the other directions of the
    /// environment that `next` has, which is the same buffer otherwise.
    void goOn(SurfaceBuffer next);

    /// Tells whether directions of an environment make any difference.
    bool isSampled() const;

    /// Returns what was computed so far; black where it is not yet, and where nothing counts.
    const LinearFrame& frame() const { return frame_; }

  private:
    ReferenceFrame() = default;

    void compute(std::size_t first, std::size_t last);

    SurfaceBuffer buffer_;
    std::vector<std::unique_ptr<SurfaceCode>> codes_; ///< by object; null: it does not count
    LinearFrame frame_;
    std::vector<glm::dvec3> still_;   ///< the part of each pixel that is not sampled
    std::vector<glm::dvec3> sampled_; ///< the sum of the others over the buffers
    int buffers_ = 0;                 ///< that are done
    std::size_t done_ = 0;            ///< pixels of the next one
};

} // namespace patina
