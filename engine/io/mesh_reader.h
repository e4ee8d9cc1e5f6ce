// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/error.h"
#include "io/mesh_folder.h"
#include "io/mesh_options.h"
#include "io/mesh_storage.h"
#include "io/report_progress.h"

namespace patina {

/// Holds what reading a mesh returns besides the mesh itself.
struct MeshReading {
    std::string remarks;             ///< says what had to be repaired; empty when nothing
    std::shared_ptr<void> leftovers; ///< freeing it may take a while: pass the mesh on first
};

/// Reads every triangle of the folder's mesh file (glTF and GLB through tinygltf, all else through
/// Assimp) into the storage: node transforms applied, triangles without area left out, normals and
/// tangents completed, taken apart by materials where the options say so, vertices joined and
/// ordered for the GPU's caches. Errors name the file; may
/// throw std::bad_alloc.
Result<MeshReading> readMesh(const std::shared_ptr<MeshFolder>& folder, const MeshOptions& options,
                             const MeshStorage& storage, const ReportProgress& report);

/// Returns the full paths of the refused files that the mesh is incomplete without, each once.
std::vector<std::string> missedPlaces(const MeshFolder& folder);

} // namespace patina
