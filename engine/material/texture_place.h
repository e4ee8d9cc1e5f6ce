// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>

#include "material/texture_use.h"

namespace patina {

/// Holds the rows that take (u, v, 1) to a place in an image: turned about its middle, scaled,
/// moved.
struct TexturePlace {
    glm::dvec3 across{1.0, 0.0, 0.0};
    glm::dvec3 up{0.0, 1.0, 0.0};

    friend bool operator==(const TexturePlace&, const TexturePlace&) = default;
};

TexturePlace texturePlace(const TextureUse& use);

} // namespace patina
