// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/sample_refinement.h"

#include <algorithm>
#include <utility>

#include "viewport/viewed_scene.h"

namespace patina {
namespace {

/// Leaves time for the rest of the window between two frames that add samples.
constexpr int pauseMs = 5;

/// Is how long nothing changes before samples take the fitted picture's place: longer than between
/// two moves of a slow hand.
constexpr int changeRestMs = 200;

/// After so many samples nothing of the fitted picture is left. The grain of n of them is shown
/// with the weight n / 256, and so never more than that of 256 is.
constexpr int mixedSamples = 256;

} // namespace

SampleRefinement::SampleRefinement(const ViewedScene& viewed) : viewed_(viewed) {
    timer_.setSingleShot(true);
    connect(&timer_, &QTimer::timeout, this, &SampleRefinement::due);
}

void SampleRefinement::beginFrame(bool isChanged, int samples) {
    isAtRest_ = !isChanged;
    isMoving_ = isChanged && viewed_.fitsWhileMoving();
    isContinued_ = isAtRest_ && samples > 0;
}

View SampleRefinement::drawn(View view) const {
    view.isContinued = isContinued_;
    view.isMoving = isMoving_;
    return view;
}

double SampleRefinement::nextShare(int samples) {
    const int all = std::min(mixedSamples, viewed_.wantedSamples());
    if (!isAtRest_) {
        mixed_ = isMoving_ ? 0 : all;
        return 1.0;
    }
    const double left = all - std::exchange(mixed_, std::min(samples, all));
    return left > 0.0 ? std::clamp(1.0 - (all - mixed_) / left, 0.0, 1.0) : 1.0;
}

bool SampleRefinement::wantsMore(int samples) const {
    return (samples > 0 || isMoving_) && samples < viewed_.wantedSamples();
}

void SampleRefinement::continueSoon(int samples) {
    if (wantsMore(samples) && (isMoving_ || !timer_.isActive())) {
        timer_.start(isMoving_ ? changeRestMs : pauseMs);
    }
}

void SampleRefinement::forgetFrame() {
    isAtRest_ = false;
    isContinued_ = false;
}

} // namespace patina
