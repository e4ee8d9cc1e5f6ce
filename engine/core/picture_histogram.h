// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/image.h"

namespace patina {

/// Counts the pixels of a picture by their red, green and blue and by their luminance. Bins are as
/// wide as each other; what lies outside the range is in the first or the last one. Values that are
/// no number are in none.
struct PictureHistogram {
    enum Channel { Red, Green, Blue, Luminance };
    using Counts = std::vector<std::uint32_t>;

    std::array<Counts, 4> counts;    ///< has one for each Channel, all of the same length
    std::uint32_t pixels = 0;        ///< is the number of pixels of the picture
    std::array<double, 4> clipped{}; ///< is the share of pixels at or above white, per Channel
    double clippedAny = 0.0;         ///< is that of pixels with a clipped channel
    double brightest = 0.0;          ///< is the largest luminance that is finite
    double black = 0.0;              ///< is the share of pixels whose channels are all 0 or less

    /// Returns the share of the pixels that a bin has.
    double share(Channel channel, std::size_t bin) const;
};

/// Counts the levels of a picture as a screen shows it, whose values are n / 255: 256 bins. White
/// is 255.
PictureHistogram levelHistogram(const Image& display);

/// Is the range of stopHistogram(), in powers of two around white, and its bins per stop.
constexpr int minStop = -10;
constexpr int maxStop = 6;
constexpr int binsPerStop = 8;

/// Says how bright a picture's pixels are, in powers of two around white.
struct BrightnessRange {
    double median = 0.0;
    double max = 0.0;
};

/// Counts the stops of a picture in linear light after exposure: the logarithm to base 2 of its
/// values, of which 0 is white. Pixels without light are in the first bin.
PictureHistogram stopHistogram(const Image& linear);

/// Returns the middle of the bin of the pixel that is brighter than one half of the others, and
/// where the brightest one is, which may be beyond the range, both by luminance, from
/// stopHistogram().
BrightnessRange brightnessOf(const PictureHistogram& stops);

} // namespace patina
