// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "measure/frame_error.h"
#include "measure/reference_frame.h"
#include "measure/sliced_capture.h"

namespace patina {

/// The frame that errors are measured against, made in steps: in double precision where the CPU can
/// compute it, else as the device draws it. Made, used and destroyed with one context current.
class RightFrame {
  public:
    /// What is wanted. Everything in it must stay.
    struct Wish {
        Renderer& renderer;
        const MeshSource& meshes;
        ChosenFrame exact;         ///< with every choice exact
        ChosenFrame drawn;         ///< the same as it is captured
        std::vector<bool> counted; ///< by object: whose pixels count
        bool inDoubles = true;     ///< false: the device's frame is the right one
    };
    explicit RightFrame(Wish wish);

    /// Works for about so long, or until the device is done with a G-buffer; true when all is done.
    Result<bool> step(std::chrono::milliseconds patience);
    double progress() const; ///< 0 .. 1
    bool isDone() const { return isDone_; }

    std::size_t pixels() const { return pixels_; }          ///< that count; 0 before it is known
    const std::string& method() const { return method_; }   ///< for people
    const ErrorMeter& meter() const { return *meter_; }     ///< of what is done

  private:
    int rounds() const;
    Result<SurfaceBuffer> captured();
    Result<void> takeComputed();
    Result<void> takeSurfaces();
    void takeBuffer(SurfaceBuffer buffer);
    Result<void> takeDrawn();

    Wish wish_;
    std::vector<std::uint8_t> counts_;
    std::size_t pixels_ = 0;
    std::string method_;
    bool isComputed_ = false; ///< in double precision
    int round_ = 0; ///< of an environment's directions
    std::unique_ptr<ReferenceFrame> reference_; ///< while it is computed
    std::optional<LinearFrame> computed_;
    std::optional<SlicedCapture> capture_;
    PieceWork preparing_; ///< of the meter
    std::optional<ErrorMeter> meter_;
    bool isDone_ = false;
};

} // namespace patina
