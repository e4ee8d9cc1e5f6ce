// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "measure/eval/eval_case.h"
#include "shading/effects/effect_set.h"
#include "shading/glsl/shader_source.h"

namespace patina {

/// Says how a program's cases and results lie in textures.
struct EvalShape {
    int caseTexels = 1;
    int resultPixels = 1;
    std::size_t results = 3; ///< numbers wanted, of the 4 per pixel (a light: 3 of each)
};

/// Rows of the textures, in texels.
constexpr int evalWidth = 1024;

/// Returns what a program holds instead of its data, as in the renderer's programs.
std::vector<CompiledValue> compiledValues(const EvalBlock& block);

/// Two cases with the same key are answered by the same program.
std::string evalKey(const EvalCase& request);

/// Returns what the program of a case needs; an error when there is no such function or it is
/// called with the wrong number of arguments.
Result<EvalShape> evalShape(const EvalCase& request);

/// Returns the fragment stage that answers the case and those with the same key.
Checked<ShaderSource> evalSource(const EvalCase& request, const EvalShape& shape,
                                 const std::filesystem::path& shaders);

/// Returns the first numbers of a case's texels: where it is evaluated, or a function's arguments.
std::vector<float> placeTexels(const EvalCase& request);

/// Returns the numbers after them: the values of the block and of what fills its slot.
std::vector<float> valueTexels(const EvalCase& request);

} // namespace patina
