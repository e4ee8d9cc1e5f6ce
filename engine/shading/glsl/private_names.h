// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "shading/glsl/shader_source.h"

namespace patina {

/// Says where the text of a user's block is within a program's.
struct BlockPart {
    std::size_t first = 0; ///< is the offset of its first byte, where a line begins
    std::size_t last = 0;  ///< is the offset behind its last byte
    std::string structName;
    std::string functionName;
};

/// Returns the program with the functions, constants, structs and macros of users' blocks limited
/// to their block where something else in the program has the same name: before such a block `name`
/// is defined as `nameOf<Struct>`, and undefined after it. Columns move in lines with such a name;
/// nothing else changes. The block's struct and function, and names that begin with theirs, belong
/// to the program and stay. So do names that are also used after a dot, where they may be a field
/// of somebody else's struct. `parts` are in the order of the text.
ShaderSource withPrivateNames(ShaderSource source, std::span<const BlockPart> parts);

} // namespace patina
