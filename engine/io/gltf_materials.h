// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <tiny_gltf.h>

#include "core/mesh_material.h"
#include "io/left_out.h"
#include "io/mesh_folder.h"

namespace patina {

/// Returns what a glTF 2.0 file says of its materials, by their numbers, and adds to `left` what of
/// their values no model has. Images inside the file are data URIs of PNG or JPEG.
std::vector<MeshMaterial> materialsFrom(const tinygltf::Model& model, MeshFolder& folder,
                                        LeftOut& left);

} // namespace patina
