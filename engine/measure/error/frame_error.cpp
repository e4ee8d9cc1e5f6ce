// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/error/frame_error.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <memory>

#include <glm/common.hpp>

#include "core/exposure.h"
#include "measure/error/parallel.h"
#include "measure/error/relative_error.h"

namespace patina {
namespace {

double quantile(std::vector<double>& values, double share) {
    const auto rank = static_cast<std::size_t>(std::ceil(share * double(values.size())));
    const auto place = values.begin() + std::ptrdiff_t(rank > 0 ? rank - 1 : 0);
    std::nth_element(values.begin(), place, values.end());
    return *place;
}

/// Adds the statistics of the relative errors of the pixels that count.
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

/// Adds the statistics of the greatest differences of display values, of the pixels that count.
void addShown(FrameError& error, const std::vector<double>& differences) {
    std::size_t steps = 0;
    for (const double difference : differences) {
        error.shown = std::max(error.shown, difference);
        steps += difference >= 1.0 / 255.0 ? 1 : 0;
    }
    error.stepShare = differences.empty() ? 0.0 : double(steps) / double(differences.size());
}

double meanOf(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double value : values) {
        sum += value;
    }
    return values.empty() ? 0.0 : sum / double(values.size());
}

/// Holds the results per pixel while a frame is compared.
struct Comparison {
    std::vector<double> map;
    std::vector<glm::dvec3> shown;
    std::vector<double> differences;
    std::vector<double> flip;
};

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

ErrorMeter::ErrorMeter(LinearFrame groundTruth, const DisplayCurve& curve, ParallelJob& work)
    : groundTruth_(std::move(groundTruth)), curve_(curve), shown_(groundTruth_.colors.size()),
      floor_(minShownLight / exposureFactor(curve.exposure)) {
    work.add(shown_.size(), [this](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            shown_[i] = curve_.shown(groundTruth_.colors[i]);
        }
    });
    flip_.emplace(groundTruth_.size, shown_, work);
}

ErrorMeter::ErrorMeter(LinearFrame groundTruth, const DisplayCurve& curve)
    : groundTruth_(std::move(groundTruth)), curve_(curve),
      floor_(minShownLight / exposureFactor(curve.exposure)) {
    shown_.reserve(groundTruth_.colors.size());
    for (const glm::dvec3& color : groundTruth_.colors) {
        shown_.push_back(curve_.shown(color));
    }
    flip_.emplace(groundTruth_.size, shown_);
}

double ErrorMeter::relative(const LinearFrame& frame, std::size_t pixel) const {
    return groundTruth_.counts[pixel] != 0
               ? relativeError(groundTruth_.colors[pixel], frame.colors[pixel], floor_)
               : 0.0;
}

std::vector<double> ErrorMeter::mapOf(const LinearFrame& frame) const {
    assert(frame.colors.size() == groundTruth_.colors.size());
    std::vector<double> map(groundTruth_.colors.size());
    inParallel(map.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            map[i] = relative(frame, i);
        }
    });
    return map;
}

FrameError ErrorMeter::errorOf(const LinearFrame& frame) const {
    ParallelJob work;
    FrameError error;
    addErrorOf(work, frame, error);
    work.finish();
    return error;
}

void ErrorMeter::addErrorOf(ParallelJob& work, const LinearFrame& frame, FrameError& error) const {
    assert(frame.colors.size() == groundTruth_.colors.size());
    const std::size_t pixels = groundTruth_.colors.size();
    const auto kept = std::make_shared<Comparison>();
    kept->map.resize(pixels);
    kept->differences.resize(pixels);
    kept->shown = shown_;
    work.add(pixels, [this, kept, &frame](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            kept->map[i] = relative(frame, i);
            if (groundTruth_.counts[i] != 0) {
                kept->shown[i] = curve_.shown(frame.colors[i]);
                kept->differences[i] = greatestOf(glm::abs(kept->shown[i] - shown_[i]));
            }
        }
    });
    flip_->addDifferences(work, kept->shown, kept->flip);
    work.addOnce([this, kept, &error] {
        error = FrameError();
        addRelative(error, ofCounted(kept->map, groundTruth_.counts));
        addShown(error, ofCounted(kept->differences, groundTruth_.counts));
        error.flip = meanOf(ofCounted(kept->flip, groundTruth_.counts));
    });
}

} // namespace patina
