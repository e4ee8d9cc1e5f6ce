// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/block.h"
#include "catalog/parameter_layout.h"

namespace patina {

/// Says where the values of one block lie in an array of vec4s.
struct BlockPlace {
    const Block* block = nullptr;
    ParameterLayout layout;
    int first = 0; ///< is the index of the block's first vec4

    int vec4s() const { return static_cast<int>(layout.floats / 4); }
};

} // namespace patina
