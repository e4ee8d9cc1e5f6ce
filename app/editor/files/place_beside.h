// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "scene/scene.h"

namespace patina {

class MeshLibrary;

/// Returns the object moved to the right of everything visible in a scene, on the same ground and
/// in the middle of its depth. Does not move it if the scene or its mesh is empty.
Object placedBeside(const Scene& scene, const Object& object, MeshLibrary& meshes);

/// Moves several objects as one, so that they keep their places relative to each other.
std::vector<Object> placedBeside(const Scene& scene, std::vector<Object> objects,
                                 MeshLibrary& meshes);

} // namespace patina
