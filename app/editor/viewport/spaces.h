// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/parameter.h"

namespace patina {

/// Tells whether a vector of this space is a place, and not a direction.
inline bool isPoint(Space space) {
    return space == Space::WorldPoint || space == Space::CameraPoint;
}

/// Tells whether a vector of this space moves with the camera.
inline bool isOfCamera(Space space) {
    return space == Space::CameraPoint || space == Space::CameraDirection;
}

} // namespace patina
