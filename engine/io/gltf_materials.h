// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <tiny_gltf.h>

#include "core/mesh_material.h"
#include "io/mesh_folder.h"

namespace patina {

/// Returns what a glTF 2.0 file says of its materials, by their numbers. Images inside the file are
/// left out.
std::vector<MeshMaterial> materialsFrom(const tinygltf::Model& model, MeshFolder& folder);

} // namespace patina
