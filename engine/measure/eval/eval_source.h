// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "measure/eval/eval_case.h"
#include "shading/effects/effect_set.h"
#include "shading/glsl/shader_source.h"

namespace patina {

/// Says how a program's cases and results are laid out in textures.
struct EvalShape {
    int caseTexels = 1;
    int resultPixels = 1;
    std::size_t results = 3; ///< is how many numbers are used, of 4 per pixel (of a light's 3)
};

/// Is the width of the textures in texels.
constexpr int evalWidth = 1024;

/// Returns the values that are compiled into the program, as in the renderer's programs.
std::vector<CompiledValue> compiledValues(const EvalBlock& block);

/// Returns a key that two cases share where the same program evaluates them.
std::string evalKey(const EvalCase& request);

/// Returns the layout for the program of a case. It is an error where there is no such function or
/// it takes another number of arguments.
Result<EvalShape> evalShape(const EvalCase& request);

/// Returns the fragment stage that evaluates the case and those with the same key.
Checked<ShaderSource> evalSource(const EvalCase& request, const EvalShape& shape,
                                 const std::filesystem::path& shaders);

/// Returns the first numbers of a case's texels: the arguments of its function.
std::vector<double> placeNumbers(const EvalCase& request);

/// Returns the numbers after them: the values of the block and of what fills its slot.
std::vector<double> valueNumbers(const EvalCase& request);

/// Return these numbers as a texture holds them.
std::vector<float> placeTexels(const EvalCase& request);
std::vector<float> valueTexels(const EvalCase& request);

} // namespace patina
