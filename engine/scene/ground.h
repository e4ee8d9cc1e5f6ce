// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>

namespace patina {

/// Tells how a scene's ground is drawn.
enum class GroundMode {
    Off,
    Shadows, ///< shows only its shadows: it darkens what is behind
    Plane    ///< is a matt plane that the lights shine on
};

/// Is a level plane on which shadows fall. It casts none, and is seen from above only.
struct Ground {
    GroundMode mode = GroundMode::Off;
    bool automatic = true;  ///< puts it at the lowest point of the objects that are drawn
    double height = 0.0;    ///< metres, where it is not automatic
    glm::dvec3 color{0.5f}; ///< is the reflectance of the plane; a float
    double opacity = 1.0;   ///< 0 .. 1, of the plane or of the shadows on it

    friend bool operator==(const Ground&, const Ground&) = default;
};

/// Tells whether anything of it can be seen.
inline bool isSeen(const Ground& ground) {
    return ground.mode != GroundMode::Off && ground.opacity > 0.0;
}

} // namespace patina
