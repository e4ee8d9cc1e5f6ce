// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace patina {

/// Describes a table that a block reads instead of computing: some levels of its accuracy choices
/// name it. The block's text defines what an entry is, at a position of 0 .. 1 along each axis, and
/// the engine makes the function that interpolates between the entries; see table_source.h.
struct BlockTable {
    std::string id;
    glm::ivec2 size{2, 1}; ///< entries along each axis, at least 2; 1: there is no second axis
    std::vector<std::string> of; ///< entries depend on the parameters with these ids

    friend bool operator==(const BlockTable&, const BlockTable&) = default;
};

} // namespace patina
