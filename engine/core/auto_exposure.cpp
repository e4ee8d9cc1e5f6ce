// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/auto_exposure.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/color.h"
#include "core/exposure.h"

namespace patina {
namespace {

constexpr double middleGrey = 0.18;
constexpr double blackest = 1e-6; ///< anything darker counts as black
constexpr double stepsPerStop = 100.0;

/// Returns the luminance of a pixel of one, three or four channels.
double luminanceAt(const Image& image, std::size_t pixel) {
    const auto channels = static_cast<std::size_t>(image.channels);
    const float* first = &image.pixels[pixel * channels];
    return channels < 3 ? double(*first) : luminance({first[0], first[1], first[2]});
}

} // namespace

std::optional<double> autoExposure(const Image& linear) {
    if (linear.channels < 1) {
        return std::nullopt;
    }
    double sum = 0.0;
    double count = 0.0;
    const std::size_t pixels = linear.pixels.size() / static_cast<std::size_t>(linear.channels);
    for (std::size_t i = 0; i < pixels; ++i) {
        const double light = luminanceAt(linear, i);
        if (std::isfinite(light) && light > blackest) {
            sum += std::log2(light);
            count += 1.0;
        }
    }
    if (count == 0.0) {
        return std::nullopt;
    }
    const double stops = std::log2(middleGrey) - sum / count;
    return std::clamp(std::round(stops * stepsPerStop) / stepsPerStop, -maxStops, maxStops);
}

} // namespace patina
