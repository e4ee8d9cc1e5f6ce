// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/number_format.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace patina {

namespace {

std::string withoutTrailingZeros(std::string text) {
    if (text.find('.') == std::string::npos) {
        return text;
    }
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') {
        text.pop_back();
    }
    return text;
}

bool isLetter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// Tells whether a digit of a unit raises the letters before it, as in "1/m2"; the digits of
/// "px/512" are a number.
bool isExponent(std::string_view unit, std::size_t digit) {
    const bool isRaised = digit > 0 && isLetter(unit[digit - 1]);
    const bool isLast =
        digit + 1 == unit.size() || std::string_view(" /*").find(unit[digit + 1]) != unit.npos;
    return isRaised && isLast;
}

} // namespace

std::string shownNumber(double value, int decimals) {
    const double size = std::abs(value);
    if (size == 0.0) {
        return "0";
    }
    if (size >= 1e7 || size < 1e-4) {
        return fmt::format("{:.3g}", value);
    }
    const int magnitude = static_cast<int>(std::floor(std::log10(size)));
    const int fourDigits = 3 - magnitude;
    const int threeDigits = 2 - magnitude;
    const int places = std::max(0, std::min(fourDigits, std::max(decimals, threeDigits)));
    return withoutTrailingZeros(fmt::format("{:.{}f}", value, places));
}

std::string shownUnit(std::string_view unit) {
    if (unit == "deg") {
        return "\u00b0";
    }
    std::string shown;
    for (std::size_t i = 0; i < unit.size(); ++i) {
        const char c = isExponent(unit, i) ? unit[i] : ' ';
        shown += c == '2' ? "\u00b2" : c == '3' ? "\u00b3" : std::string(1, unit[i]);
    }
    return shown;
}

} // namespace patina
