// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/error/converged_frame.h"

#include <algorithm>
#include <utility>

namespace patina {

ConvergedFrame::ConvergedFrame(Wish wish)
    : wish_(std::move(wish)), half_(std::max(wish_.finest.view.environmentSamples / 2, 1)),
      run_(run()) {}

Result<bool> ConvergedFrame::step(std::chrono::milliseconds patience) {
    patience_ = patience;
    return proceed(run_, problem_);
}

Steps ConvergedFrame::run() {
    LinearFrame first;
    co_await draw(1, first);
    LinearFrame mean;
    if (!problem_) {
        co_await draw(2, mean);
    }
    if (problem_) {
        co_return;
    }
    // The difference of a half from the mean is half of their difference: the mean's own standard
    // error.
    for (std::size_t i = 0; i < mean.colors.size(); ++i) {
        mean.colors[i] = 0.5 * (mean.colors[i] + first.colors[i]);
    }
    mean.counts = wish_.drawn.counts;
    ParallelJob work;
    meter_.emplace(std::move(mean), DisplayCurve::of(wish_.finest.scene, *wish_.renderer.catalog()),
                   work);
    while (!work.step(patience_)) {
        co_yield Steps::Pause();
    }
    meter_->addErrorOf(work, first, noise_);
    meter_->addErrorOf(work, wish_.drawn, finest_);
    while (!work.step(patience_)) {
        co_yield Steps::Pause();
    }
}

/// Draws half of the directions: those of this series.
Steps ConvergedFrame::draw(int series, LinearFrame& half) {
    constexpr double eachHalf = 0.45; // of the progress
    ChosenFrame frame = wish_.finest;
    frame.view.environmentSeries = series;
    frame.view.environmentSamples = half_;
    IncrementalCapture capture(wish_.renderer, wish_.meshes, std::move(frame));
    std::function<void(double)> report = [this, series](double done) {
        progress_ = eachHalf * (series - 1 + done);
    };
    Result<LinearFrame> drawn;
    co_await patina::draw(std::move(capture), patience_, std::move(report), drawn);
    if (drawn) {
        half = std::move(*drawn);
    } else {
        problem_ = drawn.error();
    }
}

} // namespace patina
