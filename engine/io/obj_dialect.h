// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace patina {

/// Tells whether an OBJ file's text has nothing but points, texture coordinates, normals and
/// triangles, all in plain decimal numbers, and names of groups and materials.
bool isPlainObj(std::string_view text);

/// Tells whether a line of the text begins with "usemtl".
bool choosesMaterials(std::string_view text);

/// Returns the text with a zero before every number that starts with its point (".5"), which Assimp
/// does not read as a number; returns nothing when there is none.
std::optional<std::string> withLeadingZeros(std::string_view text);

} // namespace patina
