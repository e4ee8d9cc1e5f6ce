// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <functional>
#include <optional>

#include "core/steps.h"
#include "measure/choice/choices.h"
#include "measure/error/linear_frame.h"

namespace patina {

/// Represents a linear frame that is drawn in slices, bit for bit the one that Renderer::capture()
/// gives: who wants it no more stops asking. The renderer and the meshes must stay, and nothing
/// else be drawn meanwhile.
class IncrementalCapture {
  public:
    IncrementalCapture(Renderer& renderer, const MeshSource& meshes, ChosenFrame frame);

    /// Draws for about so long; true when all is there.
    Result<bool> step(std::chrono::milliseconds patience);

    /// Returns 0 .. 1, by the samples of an environment, which are what takes long.
    double progress() const;

    /// Returns the frame before exposure; no pixel of it counts yet.
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
    bool continued_ = false; ///< an environment's light is added to what is there
};

/// Goes on with steps that set a problem when they fail; true when they are done.
Result<bool> proceed(Steps& run, const std::optional<Error>& problem);

/// Draws the frame in steps, each of about the patience that there is then, and tells after each of
/// them how much is done (0 .. 1).
Steps draw(IncrementalCapture capture, const std::chrono::milliseconds& patience,
           std::function<void(double)> tell, Result<LinearFrame>& drawn);

} // namespace patina
