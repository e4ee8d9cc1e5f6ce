// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/scene.h"

namespace patina {

inline void leaveGround(Scene& scene) {
    scene.ground.mode = GroundMode::Off;
}

/// Removes the ground and the lines along edges from a scene, which a frame in double precision
/// does not have.
inline void leaveSurfaces(Scene& scene) {
    leaveGround(scene);
    for (Object& object : scene.objects) {
        setPart(object.material.parts, kinds::outline, std::nullopt);
    }
}

} // namespace patina
