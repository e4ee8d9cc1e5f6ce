// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "core/error.h"
#include "io/raw_mesh.h"
#include "io/report_progress.h"

namespace patina {

/// All triangles of a file in any format Assimp knows, node transforms applied.
Result<RawMesh> readWithAssimp(const std::filesystem::path& file, const ReportProgress& report);

} // namespace patina
