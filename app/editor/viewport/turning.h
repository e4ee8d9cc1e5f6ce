// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/scene.h"

namespace patina {

/// Returns an object's rotation (degrees about x, then y, then z) after its front was pulled by the
/// mouse: `yaw` degrees about the world's up axis, `pitch` degrees about the camera's right axis.
glm::dvec3 turnedRotation(const glm::dvec3& rotation, const Camera& camera, double yaw,
                          double pitch);

/// Returns a light's values, with those that are points or directions turned around the camera's
/// pivot by the same angles. Nothing changes when the block has no position and no direction.
Values turnedLight(const Values& values, const Block& light, const Camera& camera, double yaw,
                   double pitch);

/// Tells whether turnedLight() has something to turn.
bool canTurn(const Block& light);

/// Returns the index of the light that the mouse turns: `preferred` when that is on and can turn,
/// or the first such light, or -1.
int lightToTurn(const Scene& scene, const Catalog& catalog, int preferred);

} // namespace patina
