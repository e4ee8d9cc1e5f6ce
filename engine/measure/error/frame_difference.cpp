// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/error/frame_difference.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

#include "measure/error/error_colors.h"
#include "measure/error/relative_error.h"

namespace patina {
namespace {

constexpr float greatestFloat = std::numeric_limits<float>::max();

/// Is the number of steps in a table of the sRGB curve; the first is a quarter of an 8-bit one.
constexpr std::size_t curveSteps = 1u << 14;

unsigned char eightBits(double share) {
    return static_cast<unsigned char>(std::lround(255.0 * std::clamp(share, 0.0, 1.0)));
}

/// Returns linear light encoded by the sRGB curve, IEC 61966-2-1.
double encoded(double light) {
    return light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1.0 / 2.4) - 0.055;
}

const std::array<unsigned char, curveSteps + 1>& curve() {
    static const auto made = [] {
        std::array<unsigned char, curveSteps + 1> table{};
        for (std::size_t i = 0; i < table.size(); ++i) {
            table[i] = eightBits(encoded(double(i) / double(curveSteps)));
        }
        return table;
    }();
    return made;
}

glm::dvec3 colorAt(const Image& image, std::size_t pixel) {
    const float* channels = image.pixels.data() + 4 * pixel;
    return {channels[0], channels[1], channels[2]};
}

float apartIn(double a, double b) {
    const double apart = std::abs(a - b);
    return std::isfinite(apart) ? static_cast<float>(std::min(apart, double(greatestFloat)))
                                : greatestFloat;
}

} // namespace

FrameDifference differenceOf(const Image& a, const Image& b) {
    assert(a.channels == 4 && b.channels == 4 && a.pixels.size() == b.pixels.size());
    FrameDifference difference{{a.width, a.height}, {}, {}};
    const std::size_t pixels = a.pixels.size() / 4;
    difference.apart.reserve(pixels);
    difference.relative.reserve(pixels);
    for (std::size_t i = 0; i < pixels; ++i) {
        const glm::dvec3 right = colorAt(a, i);
        const glm::dvec3 other = colorAt(b, i);
        difference.apart.emplace_back(apartIn(right.x, other.x), apartIn(right.y, other.y),
                                      apartIn(right.z, other.z));
        difference.relative.push_back(
            static_cast<float>(relativeError(right, other, minShownLight)));
    }
    return difference;
}

std::vector<unsigned char> shownDifference(const FrameDifference& difference, double gain) {
    const auto& table = curve();
    std::vector<unsigned char> bytes;
    bytes.reserve(3 * difference.apart.size());
    for (const glm::vec3& apart : difference.apart) {
        for (const float light : {apart.x, apart.y, apart.z}) {
            const double shown = std::min(gain * double(light), 1.0);
            bytes.push_back(table[static_cast<std::size_t>(shown * double(curveSteps) + 0.5)]);
        }
    }
    return bytes;
}

std::vector<unsigned char> shownErrors(const FrameDifference& difference) {
    std::vector<unsigned char> bytes;
    bytes.reserve(3 * difference.relative.size());
    for (const float error : difference.relative) {
        const glm::vec3 color = errorColor(double(error));
        for (const float channel : {color.x, color.y, color.z}) {
            bytes.push_back(eightBits(double(channel)));
        }
    }
    return bytes;
}

} // namespace patina
