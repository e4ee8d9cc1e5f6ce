// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <vector>

#include "shading/glsl/tokens.h"

namespace patina {

/// Is an argument of a function or a field of a struct. All declarations point into the text.
struct GlslVariable {
    std::string_view type;
    std::string_view name; ///< is empty when the argument has none
    bool isOut = false;    ///< the argument is declared OUT(type)
};

/// Is a function that a text defines.
struct GlslFunction {
    GlslToken name;
    std::string_view result;
    std::vector<GlslVariable> arguments;
};

struct GlslStruct {
    std::string_view name;
    std::vector<GlslVariable> fields;
};

/// Return everything that is defined outside of braces.
std::vector<GlslFunction> functionsIn(const GlslTokens& tokens);
std::vector<GlslStruct> structsIn(const GlslTokens& tokens);

} // namespace patina
