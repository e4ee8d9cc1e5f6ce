// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "core/error.h"

namespace patina {

/// Holds the instructions of a shader by kind, for single numbers: one on a vec3 counts three
/// times. As they stand in its text: what a loop repeats is counted once.
struct InstructionCount {
    int arithmetic = 0;     ///< sums, products, comparisons, choices, conversions
    int transcendental = 0; ///< divisions, roots, powers, logarithms and angles
    int texture = 0;        ///< looks into images
    int branch = 0;         ///< where the way depends on a number
    int memory = 0;         ///< loads and stores that optimisation left

    int total() const { return arithmetic + transcendental + texture + branch + memory; }

    friend bool operator==(const InstructionCount&, const InstructionCount&) = default;
};

/// Counts those of a fragment stage in GLSL: compiled to SPIR-V with glslang and optimised by
/// SPIRV-Tools, so that it says the same on every machine. Needs no OpenGL.
Result<InstructionCount> countInstructions(const std::string& fragment);

/// Counts those of a SPIR-V module.
InstructionCount countInstructions(std::span<const std::uint32_t> module);

} // namespace patina
