// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "shading/glsl/shader_source.h"

namespace patina {

/// Holds the text of a user's block within a program's.
struct BlockPart {
    std::size_t first = 0; ///< byte, where a line begins
    std::size_t last = 0;  ///< behind its last byte
    std::string structName;
    std::string functionName;
};

/// The program with the functions, constants, structs and macros of users' blocks kept to the block
/// where something else in the program has the same name: before such a block `name` is defined as
/// `nameOf<Struct>`, and no longer after it. Columns move in lines with such a name, nothing else
/// does. The block's struct and function, and what their names begin, are the program's and stay;
/// so do names that also stand behind a point, where they may be a field of somebody else's struct.
/// `parts` are in the order of the text.
ShaderSource withPrivateNames(ShaderSource source, std::span<const BlockPart> parts);

} // namespace patina
