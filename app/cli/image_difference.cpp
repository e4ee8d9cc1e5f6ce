// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/image_difference.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <vector>

#include "measure/error/flip.h"
#include "measure/error/picture_distance.h"

namespace patina {
namespace {

double meanFlip(const Image& a, const Image& b) {
    const Flip flip({a.width, a.height}, displayColors(a));
    const std::vector<double> map = flip.differences(displayColors(b));
    return std::accumulate(map.begin(), map.end(), 0.0) / double(map.size());
}

} // namespace

ImageDifference difference(const Image& a, const Image& b) {
    assert(a.pixels.size() == b.pixels.size() && a.channels == b.channels);
    assert(a.channels >= 3);
    constexpr double step = 1.0 / 255.0;
    constexpr double rounding = 1e-6; // a step between two floats is not exactly 1/255
    const int colors = std::min(a.channels, 3);
    const std::size_t pixels = std::size_t(a.width) * std::size_t(a.height);
    double squares = 0.0;
    std::size_t changed = 0;
    ImageDifference result;
    for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
        double largest = 0.0;
        for (int channel = 0; channel < colors; ++channel) {
            const std::size_t i = pixel * std::size_t(a.channels) + std::size_t(channel);
            const double apart = std::abs(double(a.pixels[i]) - double(b.pixels[i]));
            squares += apart * apart;
            largest = std::max(largest, apart);
        }
        changed += largest >= step - rounding ? 1 : 0;
        result.largest = std::max(result.largest, largest);
    }
    if (pixels > 0) {
        result.rootMeanSquare = std::sqrt(squares / double(pixels * std::size_t(colors)));
        result.changedShare = double(changed) / double(pixels);
        result.flip = meanFlip(a, b);
    }
    return result;
}

} // namespace patina
