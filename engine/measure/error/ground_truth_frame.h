// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "measure/error/frame_error.h"
#include "measure/error/incremental_capture.h"
#include "measure/error/reference_frame.h"

namespace patina {

/// Makes, in steps, the frame with which others are compared: in double precision where the CPU can
/// compute it, else as the device draws it. It must be made, used and destroyed with the same
/// context current.
class GroundTruthFrame {
  public:
    /// Says what is drawn. What it refers to must outlive the frame.
    struct Wish {
        Renderer& renderer;
        const MeshSource& meshes;
        ChosenFrame exact;         ///< has every choice exact
        ChosenFrame drawn;         ///< is the same as it is captured
        std::vector<bool> counted; ///< says for each object whether its pixels count
        bool inDoubles = true;     ///< is false where the device's frame is the ground truth
    };
    explicit GroundTruthFrame(Wish wish);
    GroundTruthFrame(const GroundTruthFrame&) = delete;
    GroundTruthFrame& operator=(const GroundTruthFrame&) = delete;

    /// Works for about so long, or until the device is done with a G-buffer, and returns true when
    /// all is done.
    Result<bool> step(std::chrono::milliseconds patience);
    double progress() const { return isDone() ? 1.0 : progress_; } ///< 0 .. 1
    bool isDone() const { return run_.isDone() && !problem_; }

    std::size_t pixels() const {
        return pixels_;
    } ///< counts those that count; 0 before it is known
    const std::string& method() const { return method_; } ///< is what users see
    const ErrorMeter& meter() const { return *meter_; }   ///< compares with it once it is done

  private:
    Steps run();
    Steps compute(std::optional<LinearFrame>& computed);
    Steps draw(const std::optional<LinearFrame>& computed);
    std::optional<SurfaceBuffer> surfaces(int round);
    void countPixels(const SurfaceBuffer& buffer);
    std::unique_ptr<ReferenceFrame> reference(SurfaceBuffer buffer);

    Wish wish_;
    std::vector<std::uint8_t> counts_;
    std::size_t pixels_ = 0;
    std::string method_;
    std::optional<ErrorMeter> meter_;
    double progress_ = 0.0;
    std::chrono::milliseconds patience_{}; ///< is the current step's
    std::optional<Error> problem_;
    Steps run_;
};

} // namespace patina
