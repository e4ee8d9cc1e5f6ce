// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <memory>
#include <vector>

#include "measure/error/linear_frame.h"
#include "measure/error/surface_code.h"

namespace patina {

/// Computes a frame on the CPU in double precision, from the inputs of each pixel that a
/// SurfaceBuffer holds. It works in steps, on all cores, and needs no OpenGL.
class ReferenceFrame {
  public:
    /// Prepares the frame; `wanted` says for each object of the scene whether its pixels count.
    /// Rays through a body of facets are followed only with the scene that the buffer is of. An
    /// error says why one of these objects cannot be computed.
    static Result<std::unique_ptr<ReferenceFrame>> create(SurfaceBuffer buffer,
                                                          const std::vector<bool>& wanted,
                                                          const BufferedScene* around = nullptr);

    /// Works for about so long, and returns true when the buffer is done.
    bool step(std::chrono::milliseconds patience);
    double progress() const; ///< 0 .. 1, of the current buffer

    /// Goes on with `next`, which is the same buffer with other directions of the environment. The
    /// frame becomes the mean over the directions of all buffers.
    void goOn(SurfaceBuffer next);

    /// Tells whether the frame depends on the directions of an environment that a buffer has.
    bool isSampled() const;

    /// Returns what was computed so far; black where it is not yet, and where nothing counts.
    const LinearFrame& frame() const { return frame_; }

  private:
    ReferenceFrame() = default;

    void compute(std::size_t first, std::size_t last);

    SurfaceBuffer buffer_;
    std::vector<std::unique_ptr<SurfaceCode>>
        codes_; ///< are by object; null where it does not count
    LinearFrame frame_;
    std::vector<glm::dvec3> still_;   ///< is the part of each pixel that is not sampled
    std::vector<glm::dvec3> sampled_; ///< is the sum of the sampled part over the buffers
    std::vector<glm::dvec3> passed_;  ///< is that of what rays see through bodies
    int buffers_ = 0;                 ///< counts those that are done
    std::size_t done_ = 0;            ///< counts pixels of the current one
};

} // namespace patina
