// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>

#include "measure/choices.h"
#include "measure/linear_frame.h"

namespace patina {

/// A linear frame that is drawn in slices, bit for bit the one that Renderer::capture() gives: who
/// wants it no more stops asking. The renderer and the meshes must stay, and nothing else be drawn
/// meanwhile.
class SlicedCapture {
  public:
    SlicedCapture(Renderer& renderer, const MeshSource& meshes, ChosenFrame frame);

    /// Draws for about so long; true when all is there.
    Result<bool> step(std::chrono::milliseconds patience);

    /// 0 .. 1, by the samples of an environment, which are what takes long.
    double progress() const;

    /// Before exposure; no pixel of it counts yet.
    Result<LinearFrame> frame() const;

  private:
    Result<void> begin();
    bool lacksSamples() const;

    Renderer& renderer_;
    const MeshSource& meshes_;
    ChosenFrame frame_;
    bool begun_ = false;
    bool isDone_ = false;
    bool continued_ = false; ///< an environment's light is added to what is there
};

} // namespace patina
