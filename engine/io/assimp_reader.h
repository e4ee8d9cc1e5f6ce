// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string_view>

#include "core/error.h"
#include "io/mesh_folder.h"
#include "io/raw_mesh.h"
#include "io/report_progress.h"

namespace patina {

/// Reads all triangles of a folder's mesh file in any format Assimp knows, node transforms applied.
/// Errors name the file.
Result<RawMesh> readWithAssimp(const std::shared_ptr<MeshFolder>& folder,
                               const ReportProgress& report);

/// Reads them from `text`, which replaces the content of the mesh file.
Result<RawMesh> readWithAssimp(const std::shared_ptr<MeshFolder>& folder, std::string_view text,
                               const ReportProgress& report);

} // namespace patina
