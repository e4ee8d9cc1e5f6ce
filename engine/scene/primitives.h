// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/mesh.h"

namespace patina {

/// Returns the names of the meshes made by code: "shaderball", "sphere", "torus", "cube", "plane",
/// "cylinder", "cone", "brilliant", "emeraldcut".
std::vector<std::string> primitiveNames();

/// Returns the mesh of one of those names, about one metre in radius, centred at the origin, with
/// exact normals, texture coordinates and tangents; nothing for another name.
std::optional<Mesh> primitive(std::string_view name);

} // namespace patina
