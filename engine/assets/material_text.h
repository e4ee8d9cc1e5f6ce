// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/mesh_material.h"

namespace patina {

/// Returns what is said of the materials of a mesh's parts, as the text that two processes share.
std::string materialText(std::span<const MeshPart> parts);

/// Returns the materials in such a text; nothing where it is not exactly one of `count` materials,
/// or has a number that is not finite.
std::optional<std::vector<MeshMaterial>> materialsIn(std::string_view text, std::size_t count);

} // namespace patina
