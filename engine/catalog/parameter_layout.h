// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "catalog/block.h"

namespace patina {

/// Says where a value of a block lies when the values are packed into vec4s. The uniform blocks,
/// `patina eval`'s data texture and the double-precision reference share this layout. A parameter
/// never straddles two vec4s; one that takes more begins with one. Compiled enums and bools have no
/// place in the uniform block, but the reference packs them too, so every parameter but a
/// shorthand, an image or what the program alone reads has a field.
struct ParameterField {
    const Parameter* parameter = nullptr; ///< is null for an accuracy choice
    const AccuracyChoice* choice = nullptr;
    std::string name;       ///< is the name in GLSL and C++
    std::size_t offset = 0; ///< floats from the start of the block's data
    int components = 1;
};

struct ParameterLayout {
    /// Holds the parameters in the descriptor's order, then the accuracy choices.
    std::vector<ParameterField> fields;
    std::size_t floats = 0; ///< is a multiple of four

    /// Returns the field of the first parameter that has the role; null where none has a place.
    const ParameterField* withRole(std::string_view role) const;
};

/// Returns the layout of one block. It points into `block`, which must outlive it.
ParameterLayout layoutOf(const Block& block);

/// Says which level of each accuracy choice is used: choice id -> level id. A missing choice is
/// exact.
using AccuracyLevels = std::map<std::string, std::string, std::less<>>;

/// Returns the values packed by the layout: angles in radians, directions unit, enums and accuracy
/// levels as the index of the chosen value, bools as 0 or 1, wavelengths that are the scene's as
/// srgbWavelengths. Missing or ill-typed values give the default.
std::vector<double> packed(const Block& block, const Values& values, const AccuracyLevels& levels);

} // namespace patina
