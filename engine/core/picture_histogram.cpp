// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/picture_histogram.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/color.h"

namespace patina {
namespace {

using Values = std::array<double, 4>;

/// Returns red, green, blue and luminance of a pixel of one, three or four channels.
Values valuesAt(const Image& image, std::size_t pixel) {
    const auto channels = static_cast<std::size_t>(image.channels);
    const float* first = &image.pixels[pixel * channels];
    if (channels < 3) {
        return {first[0], first[0], first[0], first[0]};
    }
    return {first[0], first[1], first[2], luminance({first[0], first[1], first[2]})};
}

/// Counts all pixels. `place` gives the bin of a value as a real number; a value from `white` on is
/// clipped.
template <class Place>
PictureHistogram counted(const Image& image, std::size_t bins, double white, const Place& place) {
    PictureHistogram histogram;
    histogram.counts.fill(PictureHistogram::Counts(bins, 0));
    if (image.channels < 1) {
        return histogram;
    }
    std::array<std::uint32_t, 4> clipped{};
    std::uint32_t clippedAny = 0;
    std::uint32_t black = 0;
    const std::size_t pixels = image.pixels.size() / static_cast<std::size_t>(image.channels);
    for (std::size_t i = 0; i < pixels; ++i) {
        const Values values = valuesAt(image, i);
        for (std::size_t channel = 0; channel < values.size(); ++channel) {
            const double value = values[channel];
            if (!std::isnan(value)) {
                const double bin = std::clamp(place(value), 0.0, static_cast<double>(bins - 1));
                ++histogram.counts[channel][static_cast<std::size_t>(bin)];
            }
            clipped[channel] += value >= white ? 1u : 0u;
        }
        const double brightest = std::max({values[0], values[1], values[2]});
        const double light = values[PictureHistogram::Luminance];
        histogram.brightest =
            std::isfinite(light) ? std::max(histogram.brightest, light) : histogram.brightest;
        clippedAny += brightest >= white ? 1u : 0u;
        black += brightest <= 0.0 ? 1u : 0u;
    }
    histogram.pixels = static_cast<std::uint32_t>(pixels);
    const double all = std::max<double>(1.0, static_cast<double>(pixels));
    for (std::size_t channel = 0; channel < clipped.size(); ++channel) {
        histogram.clipped[channel] = clipped[channel] / all;
    }
    histogram.clippedAny = clippedAny / all;
    histogram.black = black / all;
    return histogram;
}

} // namespace

double PictureHistogram::share(Channel channel, std::size_t bin) const {
    return pixels == 0 ? 0.0 : static_cast<double>(counts[channel][bin]) / pixels;
}

PictureHistogram levelHistogram(const Image& display) {
    constexpr double white = 254.5 / 255.0; // floats may be off n / 255 by their rounding
    return counted(display, 256, white, [](double value) { return 255.0 * value + 0.5; });
}

PictureHistogram stopHistogram(const Image& linear) {
    constexpr auto bins = static_cast<std::size_t>((maxStop - minStop) * binsPerStop);
    return counted(linear, bins, 1.0, [](double value) {
        return value > 0.0 ? (std::log2(value) - minStop) * binsPerStop : 0.0;
    });
}

BrightnessRange brightnessOf(const PictureHistogram& stops) {
    const PictureHistogram::Counts& counts = stops.counts[PictureHistogram::Luminance];
    const auto stopOf = [](double bin) { return minStop + bin / binsPerStop; };
    BrightnessRange range{minStop, minStop};
    if (stops.brightest > 0.0) {
        range.max = std::max(std::log2(stops.brightest), range.max);
    }
    std::uint64_t below = 0;
    std::uint64_t counted = 0;
    for (const std::uint32_t count : counts) {
        counted += count;
    }
    bool hasMedian = false;
    for (std::size_t bin = 0; bin < counts.size(); ++bin) {
        below += counts[bin];
        if (!hasMedian && 2 * below >= counted) {
            range.median = stopOf(static_cast<double>(bin) + 0.5);
            hasMedian = true;
        }
    }
    return range;
}

} // namespace patina
