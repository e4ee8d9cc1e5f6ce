// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/mesh_material.h"
#include "io/mesh_folder.h"

namespace patina {

/// Adds an image that a mesh file names to a material, if it may be read and is there: where the
/// file says, or where a path leads to nothing, as one of another machine does, beside the mesh
/// under the same name. Returns whether it was added.
bool addImage(MeshMaterial& material, const std::string& word, std::string path,
              MeshFolder& folder);

/// Returns the last part of a path with slashes of any kind.
std::string fileNameIn(const std::string& path);

} // namespace patina
