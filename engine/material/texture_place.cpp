// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/texture_place.h"

#include <cmath>

#include <glm/trigonometric.hpp>

namespace patina {

TexturePlace texturePlace(const TextureUse& use) {
    const double angle = glm::radians(std::fmod(use.rotation, 360.0));
    const glm::dvec2 turn(std::cos(angle), std::sin(angle));
    const glm::dvec2 across = use.scale.x * turn;
    const glm::dvec2 up = use.scale.y * glm::dvec2(-turn.y, turn.x);
    const glm::dvec2 start =
        0.5 * use.scale + use.offset - 0.5 * glm::dvec2(across.x + across.y, up.x + up.y);
    return {{across, start.x}, {up, start.y}};
}

} // namespace patina
