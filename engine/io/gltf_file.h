// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <tiny_gltf.h>

#include "core/error.h"
#include "io/mesh_folder.h"

namespace patina {

/// A glTF 2.0 or GLB file with all its buffers, images left alone. Nothing when the file is of
/// version 1, which tinygltf does not read. Errors: not glTF, a buffer that is missing or too
/// short or lies outside of the folder, an extension that is required but not known here.
Result<std::optional<tinygltf::Model>> loadGltf(MeshFolder& folder);

} // namespace patina
