// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string_view>

namespace patina {

/// Is a function of GLSL that the evaluator knows. Those of numbers work on each component.
struct ShaderBuiltin {
    enum class Form {
        Numbers, ///< takes and returns vectors of one length, or single numbers beside them
        Length,
        Dot,
        Distance,
        Normalize,
        Cross,
        Reflect,
        Any,
        All,
        Inverted, ///< is not()
        Compared, ///< is lessThan() and the like
        CaseData  ///< is a vec4 of the case that is evaluated
    };
    std::string_view name;
    std::size_t arguments = 1;
    Form form = Form::Numbers;
    double (*one)(double) = nullptr;
    double (*two)(double, double) = nullptr;
    double (*three)(double, double, double) = nullptr;
};

/// Returns the builtin function of a name with so many arguments; null where the evaluator knows
/// none.
const ShaderBuiltin* findShaderBuiltin(std::string_view name, std::size_t arguments);

} // namespace patina
