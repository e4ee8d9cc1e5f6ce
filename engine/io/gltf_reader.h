// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/error.h"
#include "io/mesh_folder.h"
#include "io/raw_mesh.h"
#include "io/report_progress.h"

namespace patina {

/// Reads all triangles of a glTF 2.0 or GLB file's default scene, node transforms applied, with
/// KHR_draco_mesh_compression, EXT_meshopt_compression and KHR_mesh_quantization. The result is
/// empty when the file is glTF 1. Errors do not name the file.
Result<std::optional<RawMesh>> readGltf(MeshFolder& folder, const ReportProgress& report);

} // namespace patina
