// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <functional>
#include <optional>

#include "core/steps.h"
#include "measure/choice/choices.h"
#include "measure/error/linear_frame.h"

namespace patina {

/// Draws a linear frame in slices, bit for bit the one that Renderer::capture() gives, so that the
/// caller can stop at any time. The renderer and the meshes must stay valid, and nothing else may
/// be drawn meanwhile.
class IncrementalCapture {
  public:
    IncrementalCapture(Renderer& renderer, const MeshSource& meshes, ChosenFrame frame);

    /// Draws for about so long, and returns true when the frame is done.
    Result<bool> step(std::chrono::milliseconds patience);

    /// Returns 0 .. 1, by the samples of an environment, which take most of the time.
    double progress() const;

    /// Returns the frame before exposure, once it is done, or the light that is shown where the
    /// finished picture is captured; its `counts` are empty.
    Result<LinearFrame> frame() const;

  private:
    void begin();
    int samples() const;
    bool needsSamples() const;

    Renderer& renderer_;
    const MeshSource& meshes_;
    ChosenFrame frame_;
    bool begun_ = false;
    bool isDone_ = false;
    bool continued_ = false; ///< says that more samples are added to the frame
};

/// Does one of the steps, which set `problem` when they fail; returns that, or true when all are
/// done.
Result<bool> proceed(Steps& run, const std::optional<Error>& problem);

/// Draws the frame in steps, each of about the current `patience`, and calls `tell` after each with
/// the share that is done (0 .. 1). `drawn` gets the frame or the error.
Steps draw(IncrementalCapture capture, const std::chrono::milliseconds& patience,
           std::function<void(double)> report, Result<LinearFrame>& drawn);

} // namespace patina
