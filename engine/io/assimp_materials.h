// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <assimp/scene.h>

#include "core/mesh_material.h"
#include "io/left_out.h"
#include "io/mesh_folder.h"

namespace patina {

/// Returns what a file says of its materials, by Assimp's numbers. Colours of formats without a
/// colour space count as what a screen shows (sRGB), those of physically based materials as linear.
/// Images that cannot be read are added to `left`.
std::vector<MeshMaterial> materialsFrom(const aiScene& scene, MeshFolder& folder, LeftOut& left);

} // namespace patina
