// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/color.h"

#include <algorithm>
#include <cmath>

namespace patina {

double srgbEncoded(double linear) {
    const double x = std::clamp(linear, 0.0, 1.0);
    return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055;
}

double srgbDecoded(double encoded) {
    const double x = std::clamp(encoded, 0.0, 1.0);
    return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
}

glm::dvec3 srgbEncoded(const glm::dvec3& linear) {
    return {srgbEncoded(linear.x), srgbEncoded(linear.y), srgbEncoded(linear.z)};
}

glm::dvec3 srgbDecoded(const glm::dvec3& encoded) {
    return {srgbDecoded(encoded.x), srgbDecoded(encoded.y), srgbDecoded(encoded.z)};
}

double luminance(const glm::dvec3& linear) {
    return 0.2126 * linear.r + 0.7152 * linear.g + 0.0722 * linear.b;
}

} // namespace patina
