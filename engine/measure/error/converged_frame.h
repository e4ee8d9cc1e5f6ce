// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "core/steps.h"
#include "measure/error/frame_error.h"
#include "measure/error/incremental_capture.h"

namespace patina {

/// Describes the render with which points are compared that draw fewer directions of an environment
/// than the exact one. All other points draw the same directions as the exact one.
struct ConvergedRender {
    std::string choice; ///< is a Choice::id: points with a level of it are compared with the render
    int directions = 0; ///< counts them per pixel; no point draws any of them
    FrameError noise;   ///< is the render's own error, by the difference of its two halves
    FrameError finest;  ///< is that of the exact frame against the render

    friend bool operator==(const ConvergedRender&, const ConvergedRender&) = default;
};

/// Draws a frame whose light of an environment is averaged over as many directions as the finest
/// frame has, but over other ones than any point of a chart draws. The frame is the mean of two
/// independent halves, whose difference gives its own error. It is made in steps, all with the same
/// context current.
class ConvergedFrame {
  public:
    /// Says what is drawn. What it refers to must outlive the frame.
    struct Wish {
        Renderer& renderer;
        const MeshSource& meshes;
        ChosenFrame finest;       ///< is the finest frame as it is captured
        const LinearFrame& drawn; ///< is the finest frame, with its counts
    };
    explicit ConvergedFrame(Wish wish);
    ConvergedFrame(const ConvergedFrame&) = delete;
    ConvergedFrame& operator=(const ConvergedFrame&) = delete;

    /// Works for about so long, and returns true when all is done.
    Result<bool> step(std::chrono::milliseconds patience);
    bool isDone() const { return run_.isDone(); }
    double progress() const { return isDone() ? 1.0 : progress_; } ///< 0 .. 1

    const ErrorMeter& meter() const { return *meter_; }  ///< compares with it once it is done
    int directions() const { return 2 * half_; }         ///< counts them per pixel
    const FrameError& noise() const { return noise_; }   ///< is that of a half against the mean
    const FrameError& finest() const { return finest_; } ///< is that of the finest frame

  private:
    Steps run();
    Steps draw(int series, LinearFrame& half);

    Wish wish_;
    int half_ = 0; ///< counts the directions of a half
    double progress_ = 0.0;
    std::optional<ErrorMeter> meter_;
    FrameError noise_;
    FrameError finest_;
    std::chrono::milliseconds patience_{}; ///< is the current step's
    std::optional<Error> problem_;
    Steps run_;
};

} // namespace patina
