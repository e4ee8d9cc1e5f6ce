// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/converged_frame.h"

#include <algorithm>
#include <utility>

namespace patina {

ConvergedFrame::ConvergedFrame(Wish wish)
    : wish_(std::move(wish)), half_(std::max(wish_.finest.view.environmentSamples / 2, 1)) {
    begin(1);
}

void ConvergedFrame::begin(int series) {
    ChosenFrame frame = wish_.finest;
    frame.view.environmentSeries = series;
    frame.view.environmentSamples = half_;
    capture_.emplace(wish_.renderer, wish_.meshes, std::move(frame));
}

Result<bool> ConvergedFrame::step(std::chrono::milliseconds patience) {
    if (capture_) {
        const Result<bool> drawn = capture_->step(patience);
        const Result<void> taken = drawn && *drawn ? takeHalf() : Result<void>();
        if (!drawn || !taken) {
            return tl::unexpected(drawn ? taken.error() : drawn.error());
        }
    } else if (stage_ == Stage::Preparing && work_.step(patience)) {
        stage_ = Stage::Comparing;
        meter_->addErrorOf(work_, first_, noise_);
        meter_->addErrorOf(work_, wish_.drawn, finest_);
    } else if (stage_ == Stage::Comparing && work_.step(patience)) {
        stage_ = Stage::Done;
    }
    return isDone();
}

double ConvergedFrame::progress() const {
    constexpr double eachHalf = 0.45;
    const double drawn = capture_ ? capture_->progress() : 1.0;
    switch (stage_) {
    case Stage::First:
        return eachHalf * drawn;
    case Stage::Second:
        return eachHalf * (1.0 + drawn);
    default:
        return isDone() ? 1.0 : 2.0 * eachHalf;
    }
}

Result<void> ConvergedFrame::takeHalf() {
    Result<LinearFrame> drawn = capture_->frame();
    if (!drawn) {
        return tl::unexpected(drawn.error());
    }
    if (stage_ == Stage::First) {
        first_ = std::move(*drawn);
        stage_ = Stage::Second;
        begin(2);
        return {};
    }
    capture_.reset();
    join(std::move(*drawn));
    return {};
}

/// Their difference from the mean is half of their difference: the mean's own standard error.
void ConvergedFrame::join(LinearFrame second) {
    for (std::size_t i = 0; i < second.colors.size(); ++i) {
        second.colors[i] = 0.5 * (second.colors[i] + first_.colors[i]);
    }
    second.counts = wish_.drawn.counts;
    meter_.emplace(std::move(second), DisplayCurve::of(wish_.finest.scene), work_);
    stage_ = Stage::Preparing;
}

} // namespace patina
