// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "core/error.h"
#include "core/mesh_material.h"

namespace patina {

/// Writes the images that are data URIs in a material of a mesh file into a folder, each content
/// once and under its hash, and names those files in their place. Images that cannot be written are
/// left out, with an error for each.
Errors keepEmbeddedImages(MeshMaterial& material, const std::filesystem::path& folder);

} // namespace patina
