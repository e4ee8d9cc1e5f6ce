// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "shading/glsl/shader_source.h"

namespace patina {

/// Is a name, a number or an operator of a shader, after its macros were replaced.
struct ShaderLexeme {
    std::string_view text;
    std::size_t first = 0; ///< is the offset of its first byte in the text; of a macro's use, of it
    std::size_t last = 0;
    bool isNumber = false;
    bool isMade = false; ///< a macro put it there
    int file = 0;        ///< is an index of ShaderSource::files
};

/// Returns the lexemes of a shader without comments, as GLSL's preprocessor leaves them; they point
/// into the text. It is an error, at its place, where a directive is not understood.
Result<std::vector<ShaderLexeme>> shaderLexemes(const ShaderSource& source);

} // namespace patina
