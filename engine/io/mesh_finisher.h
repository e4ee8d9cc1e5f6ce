// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/error.h"
#include "io/mesh_options.h"
#include "io/mesh_storage.h"
#include "io/raw_mesh.h"

namespace patina {

/// Turns the triangles of a file into what the renderer draws, and writes that into the storage.
/// Returns a sentence on what was left out, empty when nothing was. It is an error when no triangle
/// is left; errors do not name the file.
Result<std::string> finishMesh(RawMesh mesh, const MeshOptions& options,
                               const MeshStorage& storage);

} // namespace patina
