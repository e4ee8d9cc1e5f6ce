// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "core/error.h"
#include "shading/program/program_source.h"

namespace patina {

/// Counts the instructions of a shader by kind and for single numbers: one on a vec3 counts three
/// times. What a loop repeats is counted once.
struct InstructionCount {
    int arithmetic = 0;     ///< counts sums, products, comparisons, choices, conversions
    int transcendental = 0; ///< counts divisions, roots, powers, logarithms and angles
    int texture = 0;        ///< counts reads of images
    int branch = 0;         ///< counts conditional branches
    int memory = 0;         ///< counts loads and stores that optimisation left

    int total() const { return arithmetic + transcendental + texture + branch + memory; }

    friend bool operator==(const InstructionCount&, const InstructionCount&) = default;
};

/// Counts the instructions of a fragment stage in GLSL. It is compiled to SPIR-V with glslang and
/// optimised by SPIRV-Tools, so that the result is the same on every machine. It needs no OpenGL.
/// It is an error where the text does not compile.
Result<InstructionCount> countInstructions(const std::string& fragment);

/// Returns the mistakes that glslang finds in a fragment stage, each with its file, line and
/// column.
Errors compilerMistakes(const ShaderSource& fragment);

/// Returns the mistakes that glslang finds in all stages of a program, each once.
Errors compilerMistakes(const ProgramSource& program);

/// Counts the instructions of a SPIR-V module.
InstructionCount countInstructions(std::span<const std::uint32_t> module);

} // namespace patina
