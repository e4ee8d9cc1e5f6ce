// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/display_image.h"

#include <algorithm>
#include <cstdint>

#include "core/srgb_table.h"

namespace patina {

Image linearFromDisplay(Image display) {
    const SrgbTable srgb;
    for (std::size_t i = 0; i < display.pixels.size(); ++i) {
        if (display.channels != 4 || i % 4 != 3) {
            const float code = std::clamp(display.pixels[i], 0.0f, 1.0f) * 255.0f + 0.5f;
            display.pixels[i] = srgb.decoded(static_cast<std::uint8_t>(code));
        }
    }
    return display;
}

} // namespace patina
