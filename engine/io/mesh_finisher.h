// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/error.h"
#include "io/mesh_options.h"
#include "io/mesh_storage.h"
#include "io/raw_mesh.h"

namespace patina {

/// Turns the triangles of a file into what the renderer draws, and writes that into the storage.
/// Gives a sentence on what was left out; errors when nothing is left (without the file's name).
Result<std::string> finishMesh(RawMesh mesh, const MeshOptions& options,
                               const MeshStorage& storage);

} // namespace patina
