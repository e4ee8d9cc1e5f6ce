// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/frame_error.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <glm/common.hpp>

#include "measure/parallel.h"
#include "measure/relative_error.h"

namespace patina {
namespace {

double quantile(std::vector<double>& values, double share) {
    const auto rank = static_cast<std::size_t>(std::ceil(share * double(values.size())));
    const auto place = values.begin() + std::ptrdiff_t(rank > 0 ? rank - 1 : 0);
    std::nth_element(values.begin(), place, values.end());
    return *place;
}

/// Relative errors of the pixels that count.
void addRelative(FrameError& error, std::vector<double> shares) {
    double sum = 0.0;
    double squares = 0.0;
    for (const double share : shares) {
        error.max = std::max(error.max, share);
        sum += share;
        squares += share * share;
    }
    const auto count = static_cast<double>(shares.size());
    error.pixels = shares.size();
    if (!shares.empty()) {
        error.mean = sum / count;
        error.rms = std::sqrt(squares / count);
        error.p99 = quantile(shares, 0.99);
    }
}

/// Greatest differences on the display, of the pixels that count.
void addShown(FrameError& error, const std::vector<double>& differences) {
    std::size_t steps = 0;
    for (const double difference : differences) {
        error.shown = std::max(error.shown, difference);
        steps += difference >= 1.0 / 255.0 ? 1 : 0;
    }
    error.stepShare = differences.empty() ? 0.0 : double(steps) / double(differences.size());
}

std::vector<glm::dvec3> shownOf(const LinearFrame& frame, const DisplayCurve& curve) {
    std::vector<glm::dvec3> shown(frame.colors.size());
    inParallel(shown.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            shown[i] = curve.shown(frame.colors[i]);
        }
    });
    return shown;
}

double meanOf(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double value : values) {
        sum += value;
    }
    return values.empty() ? 0.0 : sum / double(values.size());
}

std::vector<double> ofCounted(const std::vector<double>& all,
                              const std::vector<std::uint8_t>& counts) {
    std::vector<double> kept;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (counts[i] != 0) {
            kept.push_back(all[i]);
        }
    }
    return kept;
}

} // namespace

ErrorMeter::ErrorMeter(LinearFrame right, const DisplayCurve& curve)
    : right_(std::move(right)), curve_(curve), shown_(shownOf(right_, curve)),
      floor_(leastShownLight / curve.factor()), flip_(right_.size, shown_) {}

std::vector<double> ErrorMeter::mapOf(const LinearFrame& frame) const {
    assert(frame.colors.size() == right_.colors.size());
    std::vector<double> map(right_.colors.size());
    inParallel(map.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            map[i] = right_.counts[i] != 0
                         ? relativeError(right_.colors[i], frame.colors[i], floor_)
                         : 0.0;
        }
    });
    return map;
}

FrameError ErrorMeter::errorOf(const LinearFrame& frame) const {
    FrameError error;
    addRelative(error, ofCounted(mapOf(frame), right_.counts));
    std::vector<glm::dvec3> shown = shown_;
    std::vector<double> differences(shown.size());
    inParallel(differences.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            if (right_.counts[i] != 0) {
                shown[i] = curve_.shown(frame.colors[i]);
                differences[i] = greatestOf(glm::abs(shown[i] - shown_[i]));
            }
        }
    });
    addShown(error, ofCounted(differences, right_.counts));
    error.flip = meanOf(ofCounted(flip_.differences(shown), right_.counts));
    return error;
}

} // namespace patina
