// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <vector>

#include "measure/approximation/measured_text.h"

namespace patina {

/// Is a dialect of GLSL with types of 16 bits (float16_t, f16vec2 ...).
struct HalfDialect {
    std::string_view extension;
    bool hasFunctions = true; ///< says that pow() and the like take these types; else float ones
};

/// Is what glslang knows when it compiles for Vulkan.
inline constexpr HalfDialect vulkanHalf{"GL_EXT_shader_explicit_arithmetic_types_float16"};

/// Returns the edits with which the marked expressions of a block's own functions are computed in
/// floats of 16 bits, each operation by itself: operands become such floats, a value that is used
/// by others a float again. A variable that only marked expressions give values has such a type.
/// The text's version becomes 4.50, with the dialect's extension. Matrices, structs and arrays stay
/// as they are.
std::vector<ShaderEdit> halfEdits(const MeasuredText& text, const std::vector<bool>& halved,
                                  const HalfDialect& dialect);

} // namespace patina
