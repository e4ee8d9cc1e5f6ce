// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "core/steps.h"
#include "measure/error/frame_error.h"
#include "measure/error/incremental_capture.h"

namespace patina {

/// Holds what errors are against where points draw fewer directions of an environment than the
/// exact one: all others have the same directions as that.
struct ConvergedRender {
    std::string choice; ///< Choice::id: points with a level of it are compared with the render
    int directions = 0; ///< per pixel; no point draws any of them
    FrameError noise;   ///< what the render itself is off by, by the difference of its two halves
    FrameError finest;  ///< of the exact frame against the render

    friend bool operator==(const ConvergedRender&, const ConvergedRender&) = default;
};

/// Represents a frame whose light of an environment is a mean over as many directions as the finest
/// frame has, none of which that one or any coarser one draws. It is the mean of two halves that
/// have nothing to do with each other, which says how far it can be trusted. Made in steps, with
/// one context current.
class ConvergedFrame {
  public:
    /// Holds what is wanted. All that is referred to must stay.
    struct Wish {
        Renderer& renderer;
        const MeshSource& meshes;
        ChosenFrame finest;       ///< as it is captured
        const LinearFrame& drawn; ///< the finest frame, with its counts
    };
    explicit ConvergedFrame(Wish wish);
    ConvergedFrame(const ConvergedFrame&) = delete;
    ConvergedFrame& operator=(const ConvergedFrame&) = delete;

    /// Works for about so long; true when all is done.
    Result<bool> step(std::chrono::milliseconds patience);
    bool isDone() const { return run_.isDone(); }
    double progress() const { return isDone() ? 1.0 : progress_; } ///< 0 .. 1

    const ErrorMeter& meter() const { return *meter_; }  ///< of what is done
    int directions() const { return 2 * half_; }         ///< per pixel
    const FrameError& noise() const { return noise_; }   ///< of one half against the mean
    const FrameError& finest() const { return finest_; } ///< of the finest frame

  private:
    Steps run();
    Steps draw(int series, LinearFrame& half);

    Wish wish_;
    int half_ = 0; ///< directions
    double progress_ = 0.0;
    std::optional<ErrorMeter> meter_;
    FrameError noise_;
    FrameError finest_;
    std::chrono::milliseconds patience_{}; ///< of the step that is on
    std::optional<Error> problem_;
    Steps run_;
};

} // namespace patina
