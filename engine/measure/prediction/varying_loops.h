// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "catalog/catalog.h"
#include "material/material.h"

namespace patina {

/// Is a loop of a model's text that runs as often as the directions of light and viewer, or the
/// model's values, call for, or one around such a loop.
struct VaryingLoop {
    std::string function;  ///< is the name of the function that it stands in
    std::size_t place = 0; ///< counts the loops of that function before it
    double rounds = 0.0;   ///< are those of one run of it, on the mean of directions and channels
    bool isVarying = true; ///< false: it has so many rounds always, with one that varies in them
};

/// Returns the loops of the model's function, and of those that it calls, whose rounds vary over
/// pairs of directions above the surface, with the material's values and accuracy levels, or that
/// ask for a value, and those around them. None where its text cannot be evaluated on the CPU.
std::vector<VaryingLoop> varyingLoops(const Material& material, const Catalog& catalog);

/// Returns the GLSL text of a stage with `rounds` rounds of each of these loops, written out one
/// after the other; nothing where one is not there, is no `for`, or has a break or a continue.
std::optional<std::string> withRounds(const std::string& glsl, std::span<const VaryingLoop> loops,
                                      std::span<const int> rounds);

} // namespace patina
