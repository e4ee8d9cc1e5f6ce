// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/srgb_table.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/color.h"

namespace patina {

namespace {

/// Returns the 8-bit code of an alpha, which is clamped to [0, 1]; NaN gives 0.
std::uint8_t alphaCode(float alpha) {
    return alpha > 0.0f ? static_cast<std::uint8_t>(std::lround(std::min(alpha, 1.0f) * 255.0f))
                        : 0;
}

} // namespace

SrgbTable::SrgbTable() {
    for (int code = 0; code < 256; ++code) {
        linear_[code] = static_cast<float>(srgbDecoded(code / 255.0));
        upper_[code] = static_cast<float>(srgbDecoded((code + 0.5) / 255.0));
    }
    upper_[255] = std::numeric_limits<float>::infinity();
    std::uint8_t code = 0;
    for (int slot = 0; slot < slots; ++slot) {
        while (static_cast<float>(slot) / slots >= upper_[code]) {
            ++code;
        }
        first_[slot] = code;
    }
}

std::uint8_t SrgbTable::encoded(float linear) const {
    if (!(linear > 0.0f)) {
        return 0;
    }
    if (linear >= 1.0f) {
        return 255;
    }
    std::uint8_t code = first_[static_cast<int>(linear * slots)];
    while (linear >= upper_[code]) {
        ++code;
    }
    return code;
}

std::vector<std::uint8_t> SrgbTable::codes(const Image& image, int channels) const {
    const auto from = static_cast<std::size_t>(image.channels);
    std::vector<std::uint8_t> all;
    all.reserve(image.pixels.size() / from * std::size_t(channels));
    for (std::size_t i = 0; i + from <= image.pixels.size(); i += from) {
        for (int c = 0; c < channels; ++c) {
            const float value = image.pixels[i + (from == 1 ? 0 : std::size_t(c))];
            all.push_back(c == 3 ? alphaCode(value) : encoded(value));
        }
    }
    return all;
}

} // namespace patina
