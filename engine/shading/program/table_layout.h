// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec2.hpp>

#include "shading/program/block_place.h"
#include "shading/program/block_use.h"

namespace patina {

/// Tells in which part of a program a block reads a table.
enum class TableReader { Model, Slot, Blend };

/// Says where a table that a program reads lies in the texture of the material's tables.
struct TablePlace {
    const Block* block = nullptr;
    const BlockTable* table = nullptr;
    TableReader reader = TableReader::Model;
    int first = 0; ///< is the index of the block's first vec4 in `objectData`
    int row = 0;   ///< is the first of table->size.y rows; each entry is a texel
};

/// Places all tables of a program one above the other in one texture.
struct TableLayout {
    std::vector<TablePlace> places;
    glm::ivec2 size{0}; ///< texels of the texture
    /// Lists the indices of the floats of `objectData` that entries depend on.
    std::vector<std::size_t> inputs;

    bool empty() const { return places.empty(); }

    /// Adds the tables that the block's levels in `use` read. It keeps pointers into the block.
    void add(const BlockPlace& place, const BlockUse& use, TableReader reader);

    /// Tells whether the program reads this table.
    bool has(const BlockTable& table) const;
};

} // namespace patina
