// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "core/error.h"
#include "io/mesh_options.h"
#include "io/mesh_storage.h"
#include "io/report_progress.h"

namespace patina {

/// Reads every triangle of a mesh file (glTF and GLB through tinygltf, all else through Assimp)
/// into the storage: node transforms applied, triangles without area left out, normals and
/// tangents completed, vertices joined and ordered for the GPU's caches. Gives a sentence on what
/// had to be repaired, empty when nothing. Errors name the file; may throw std::bad_alloc.
Result<std::string> readMesh(const std::filesystem::path& file, const MeshOptions& options,
                             const MeshStorage& storage, const ReportProgress& report);

} // namespace patina
