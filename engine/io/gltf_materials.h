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

/// Tells whether a material mixes metal and dielectric, by a share or by an image, and is not one
/// of those that are told otherwise: with a grain, or with a transmission.
bool isMixed(const tinygltf::Material& material, const tinygltf::Model& model);

/// Tells whether the image of roughness and metalness is one of ours, in which all is metal.
bool isRoughnessAlone(const tinygltf::Model& model, const tinygltf::PbrMetallicRoughness& look);

} // namespace patina
