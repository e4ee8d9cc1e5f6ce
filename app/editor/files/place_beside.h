// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "scene/scene.h"

namespace patina {

class MeshLibrary;

/// The object moved to the right of all that is visible in a scene, standing as deep as it does.
/// Nothing moves where the scene, or the object's own mesh, is empty.
Object placedBeside(const Scene& scene, const Object& object, MeshLibrary& meshes);

/// Several objects, which stay as they stand to each other.
std::vector<Object> placedBeside(const Scene& scene, std::vector<Object> objects,
                                 MeshLibrary& meshes);

} // namespace patina
