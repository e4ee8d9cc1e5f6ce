// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/images/srgb_table.h"

#include <limits>

#include "core/color.h"

namespace patina {

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

} // namespace patina
