// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tiny_gltf.h>

#include "core/error.h"
#include "io/gltf_views.h"
#include "io/raw_mesh.h"

namespace patina {

/// Returns the triangles of one primitive, strips and fans taken apart; points and lines are only
/// counted.
Result<RawMesh> readPrimitive(const tinygltf::Model& model, GltfViews& views,
                              const tinygltf::Primitive& primitive);

} // namespace patina
