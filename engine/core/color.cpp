// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/color.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

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

std::string hexOf(const glm::dvec3& linear) {
    const glm::dvec3 encoded = srgbEncoded(linear) * 255.0;
    return fmt::format("#{:02x}{:02x}{:02x}", std::lround(encoded.x), std::lround(encoded.y),
                       std::lround(encoded.z));
}

std::optional<glm::dvec3> colorOfHex(std::string_view text) {
    constexpr std::string_view around = "# \t";
    const std::size_t first = std::min(text.find_first_not_of(around), text.size());
    std::string digits(text.substr(first, text.find_last_not_of(around) + 1 - first));
    if (digits.size() == 3) { // "#8cf" is short for "#88ccff"
        digits = {digits[0], digits[0], digits[1], digits[1], digits[2], digits[2]};
    }
    unsigned bits = 0;
    const char* end = digits.data() + digits.size();
    const auto [stop, status] = std::from_chars(digits.data(), end, bits, 16);
    if (digits.size() != 6 || status != std::errc() || stop != end) {
        return std::nullopt;
    }
    const glm::dvec3 encoded((bits >> 16) & 0xffu, (bits >> 8) & 0xffu, bits & 0xffu);
    return srgbDecoded(encoded / 255.0);
}

} // namespace patina
