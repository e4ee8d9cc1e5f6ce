// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/scene.h"

namespace patina {

inline void leaveGround(Scene& scene) {
    scene.ground.mode = GroundMode::Off;
}

/// Leaves a scene the surfaces of its objects alone: neither the ground nor lines along edges, of
/// which a frame that is evaluated in double precision knows nothing.
inline void leaveSurfaces(Scene& scene) {
    leaveGround(scene);
    for (Object& object : scene.objects) {
        setPart(object.material.parts, kinds::outline, std::nullopt);
    }
}

} // namespace patina
