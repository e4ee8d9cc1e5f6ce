// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tiny_gltf.h>

#include "core/error.h"
#include "io/gltf_views.h"
#include "io/raw_mesh.h"

namespace patina {

/// Tells whether the primitive's data is in KHR_draco_mesh_compression.
bool isDraco(const tinygltf::Primitive& primitive);

/// Returns the triangles of such a primitive; damaged data is an error.
Result<RawMesh> readDraco(const tinygltf::Model& model, GltfViews& views,
                          const tinygltf::Primitive& primitive);

} // namespace patina
