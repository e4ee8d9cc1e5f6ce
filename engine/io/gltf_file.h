// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <tiny_gltf.h>

#include "core/error.h"
#include "io/mesh_folder.h"

namespace patina {

/// Loads a glTF 2.0 or GLB file with all its buffers, but without its images. The result is empty
/// when the file is of version 1, which tinygltf does not read. It is an error when the file is not
/// glTF, when a buffer is missing, too short or outside of the folder, or when a required extension
/// is not known here.
Result<std::optional<tinygltf::Model>> loadGltf(MeshFolder& folder);

/// Decodes the percent escapes of a URI: "%2e%2e" becomes "..".
std::string withoutEscapes(std::string_view uri);

} // namespace patina
