// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tiny_gltf.h>

#include "core/mesh_material.h"
#include "io/mesh_folder.h"

namespace patina {

/// Takes from a material's extras the preset that it was exported from, unless another program has
/// changed its factors since, and what only other programs know.
void addExtras(MeshMaterial& material, const tinygltf::Material& from, const tinygltf::Model& model,
               MeshFolder& folder);

/// Tells whether a material has extras of other programs.
bool hasForeignExtras(const tinygltf::Material& material);

} // namespace patina
