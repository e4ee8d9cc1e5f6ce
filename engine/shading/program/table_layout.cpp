// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/program/table_layout.h"

#include <algorithm>

namespace patina {
namespace {

void addInputs(std::vector<std::size_t>& inputs, const BlockPlace& place, const BlockTable& table) {
    for (const ParameterField& field : place.layout.fields) {
        const bool counts = field.parameter != nullptr &&
                            std::ranges::find(table.of, field.parameter->id) != table.of.end();
        for (int i = 0; counts && i < field.components; ++i) {
            inputs.push_back(4 * static_cast<std::size_t>(place.first) + field.offset +
                             static_cast<std::size_t>(i));
        }
    }
}

} // namespace

void TableLayout::add(const BlockPlace& place, const BlockUse& use, TableReader reader) {
    for (const AccuracyChoice& choice : place.block->accuracy) {
        const BlockTable* table =
            choice.values.empty() ? nullptr : place.block->table(use.level(choice).table);
        if (table == nullptr || has(*table)) {
            continue;
        }
        places.push_back({place.block, table, reader, place.first, size.y});
        size = {std::max(size.x, table->size.x), size.y + table->size.y};
        addInputs(inputs, place, *table);
    }
}

bool TableLayout::has(const BlockTable& table) const {
    return std::ranges::any_of(places, [&table](const TablePlace& p) { return p.table == &table; });
}

} // namespace patina
