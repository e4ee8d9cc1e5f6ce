// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/error/error_colors.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include <glm/common.hpp>

namespace patina {
namespace {

/// Holds a colour for every power of ten; each is lighter than the one before.
constexpr std::array<glm::vec3, 7> colorStops{{{0.00f, 0.00f, 0.00f},
                                               {0.16f, 0.08f, 0.35f},
                                               {0.42f, 0.10f, 0.46f},
                                               {0.71f, 0.18f, 0.40f},
                                               {0.92f, 0.38f, 0.22f},
                                               {0.99f, 0.67f, 0.24f},
                                               {1.00f, 0.97f, 0.72f}}};

} // namespace

glm::vec3 errorColor(double relative) {
    if (std::isnan(relative)) {
        return colorStops.back();
    }
    const double shown = std::clamp(relative, minErrorShown, greatestErrorShown);
    const double share =
        std::log(shown / minErrorShown) / std::log(greatestErrorShown / minErrorShown);
    const double place = share * double(colorStops.size() - 1);
    const std::size_t below = std::min(static_cast<std::size_t>(place), colorStops.size() - 2);
    return glm::mix(colorStops[below], colorStops[below + 1],
                    static_cast<float>(place - double(below)));
}

Image errorPicture(std::span<const double> errors, glm::ivec2 size) {
    assert(errors.size() == std::size_t(size.x) * std::size_t(size.y));
    Image image{size.x, size.y, 3, {}};
    image.pixels.reserve(3 * errors.size());
    for (const double error : errors) {
        const glm::vec3 color = errorColor(error);
        image.pixels.insert(image.pixels.end(), {color.x, color.y, color.z});
    }
    return image;
}

} // namespace patina
