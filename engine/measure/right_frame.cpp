// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/right_frame.h"

#include <utility>

#include <fmt/format.h>

#include "render/environment_light.h"

namespace patina {

namespace {

/// Shares of the progress: what is computed in double precision, and what is made ready for
/// comparing in the end.
constexpr double computedShare = 0.7;
constexpr double preparedShare = 0.1;

} // namespace

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
        if (auto taken = takeComputed(); !taken) {
            return tl::unexpected(taken.error());
        }
    }
    return isDone_;
}

/// How many rounds of an environment's directions the frame in double precision has.
int RightFrame::rounds() const {
    return reference_->isSampled()
               ? wish_.drawn.view.environmentSamples / EnvironmentLight::roundSamples
               : 1;
}

/// Goes on with the next round of directions, which are those that the device draws.
Result<void> RightFrame::takeComputed() {
    if (++round_ < rounds()) {
        return captured().map(
            [this](SurfaceBuffer buffer) { reference_->goOn(std::move(buffer)); });
    }
    if (reference_->isSampled()) {
        method_ += fmt::format(" and with the same {} directions of the environment per pixel",
                               wish_.drawn.view.environmentSamples);
    }
    computed_ = reference_->frame();
    reference_.reset();
    capture_.emplace(wish_.renderer, wish_.meshes, wish_.drawn);
    return {};
}

Result<SurfaceBuffer> RightFrame::captured() {
    return wish_.renderer.captureSurfaces(wish_.exact.scene, wish_.exact.view, wish_.meshes,
                                          round_);
}

double RightFrame::progress() const {
    const double computed =
        reference_ ? (round_ + reference_->progress()) / rounds() : meter_ || capture_ ? 1.0 : 0.0;
    const double drawn = meter_ ? 1.0 : capture_ ? capture_->progress() : 0.0;
    const double before = method_.empty() || isComputed_ ? computedShare : 0.0;
    const double prepared = isDone_ ? 1.0 : 0.0;
    return before * computed + (1.0 - before - preparedShare) * drawn + preparedShare * prepared;
}

Result<void> RightFrame::takeSurfaces() {
    auto buffer = captured();
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
            isComputed_ = true;
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
        method_ = fmt::format("{}, with the same {} directions of the environment per pixel",
                              method_, directions);
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
