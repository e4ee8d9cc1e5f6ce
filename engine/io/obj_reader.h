// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/error.h"
#include "io/raw_mesh.h"
#include "io/report_progress.h"

namespace patina {

/// Reads the triangles of an OBJ file through tinyobjloader, which keeps the file's shared corners
/// where Assimp takes them apart, and so needs half the time and a third of the memory for a large
/// mesh. Returns nothing when the file uses more of the format than tinyobjloader reads faithfully
/// (polygons, continued lines, homogeneous coordinates, NaN) or is damaged, and when `byMaterial`
/// and it has materials: ask Assimp then.
std::optional<RawMesh> readPlainObj(const std::filesystem::path& file, bool byMaterial,
                                    const ReportProgress& report);

/// Returns an OBJ file's text as Assimp understands it (see withLeadingZeros; without a byte order
/// mark), or nothing when Assimp can read the file itself. Ambiguous commas are an error.
Result<std::optional<std::string>> objForAssimp(const std::filesystem::path& file);

} // namespace patina
