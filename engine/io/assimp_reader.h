// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string_view>

#include "core/error.h"
#include "io/raw_mesh.h"
#include "io/report_progress.h"

namespace patina {

/// All triangles of a file in any format Assimp knows, node transforms applied.
Result<RawMesh> readWithAssimp(const std::filesystem::path& file, const ReportProgress& report);

/// The same of a text that stands for the file's own.
Result<RawMesh> readWithAssimp(const std::filesystem::path& file, std::string_view text,
                               const ReportProgress& report);

} // namespace patina
