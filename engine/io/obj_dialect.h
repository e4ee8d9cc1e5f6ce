// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace patina {

/// True when an OBJ file's text has nothing but points, texture coordinates, normals and
/// triangles, all in plain decimal numbers, and names of groups and materials.
bool isPlainObj(std::string_view text);

/// The text with a zero before every number that starts with its point (".5"), which Assimp takes
/// for no number; nothing when there is none.
std::optional<std::string> withLeadingZeros(std::string_view text);

} // namespace patina
