// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/right_frame.h"

#include <utility>

#include <fmt/format.h>

namespace patina {

RightFrame::RightFrame(Wish wish) : wish_(std::move(wish)) {}

Result<bool> RightFrame::step(std::chrono::milliseconds patience) {
    if (isDone_) {
        return true;
    }
    if (meter_) {
        isDone_ = preparing_.step(patience);
    } else if (capture_) {
        const Result<bool> drawn = capture_->step(patience);
        const Result<void> taken = drawn && *drawn ? takeDrawn() : Result<void>();
        if (!drawn || !taken) {
            return tl::unexpected(drawn ? taken.error() : drawn.error());
        }
    } else if (!reference_) {
        if (auto taken = takeSurfaces(); !taken) {
            return tl::unexpected(taken.error());
        }
    } else if (reference_->step(patience)) {
        computed_ = reference_->frame();
        reference_.reset();
        capture_.emplace(wish_.renderer, wish_.meshes, wish_.drawn);
    }
    return isDone_;
}

double RightFrame::progress() const {
    return reference_ ? reference_->progress() : capture_ || meter_ ? 1.0 : 0.0;
}

Result<void> RightFrame::takeSurfaces() {
    auto buffer = wish_.renderer.captureSurfaces(wish_.exact.scene, wish_.exact.view, wish_.meshes);
    if (!buffer) {
        return tl::unexpected(buffer.error());
    }
    counts_.resize(buffer->pixels());
    for (std::size_t i = 0; i < counts_.size(); ++i) {
        const std::optional<std::size_t> object = buffer->objectAt(i);
        counts_[i] = object && wish_.counted[*object] ? 1 : 0;
        pixels_ += counts_[i];
    }
    if (pixels_ == 0) {
        return failure("nothing of the material is in the picture", "an object in view");
    }
    takeBuffer(std::move(*buffer));
    return {};
}

/// What cannot be computed on the CPU is compared with what the device draws with every choice
/// exact.
void RightFrame::takeBuffer(SurfaceBuffer buffer) {
    method_ = "the finest frame that the device draws";
    if (wish_.inDoubles) {
        auto made = ReferenceFrame::create(std::move(buffer), wish_.counted);
        if (made) {
            reference_ = std::move(*made);
            method_ = "the same frame in double precision";
            return;
        }
        method_ = fmt::format("the exact frame as the device draws it, because {}",
                              made.error().problem);
    }
    capture_.emplace(wish_.renderer, wish_.meshes, wish_.drawn);
}

/// What does not count is as the device draws it.
Result<void> RightFrame::takeDrawn() {
    Result<LinearFrame> drawn = capture_->frame();
    if (!drawn) {
        return tl::unexpected(drawn.error());
    }
    if (const int directions = wish_.renderer.environmentSamples(); !computed_ && directions > 0) {
        method_ = fmt::format("{}, with {} directions of the environment per pixel",
                              wish_.inDoubles ? method_ : "a converged render: " + method_,
                              directions);
    }
    for (std::size_t i = 0; computed_ && i < counts_.size(); ++i) {
        if (counts_[i] != 0) {
            drawn->colors[i] = computed_->colors[i];
        }
    }
    drawn->counts = std::move(counts_);
    computed_.reset();
    const DisplayCurve curve = DisplayCurve::of(wish_.exact.scene);
    meter_.emplace(std::move(*drawn), curve, preparing_);
    capture_.reset();
    return {};
}

} // namespace patina
