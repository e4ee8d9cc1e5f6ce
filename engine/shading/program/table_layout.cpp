// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/program/table_layout.h"

#include <algorithm>

#include <fmt/format.h>

namespace patina {
namespace {

const EnumValue* levelOf(const AccuracyChoice& choice, const BlockUse& use) {
    const auto compiled = std::ranges::find(use.compiled, choice.id, &CompiledValue::id);
    if (compiled == use.compiled.end()) {
        return nullptr;
    }
    const auto level = std::ranges::find(choice.values, compiled->value, &EnumValue::id);
    return level == choice.values.end() ? nullptr : &*level;
}

void addInputs(std::vector<std::size_t>& inputs, const BlockPlace& place,
               const BlockTable& table) {
    for (const ParameterField& field : place.layout.fields) {
        const bool counts = field.parameter != nullptr &&
                            std::ranges::find(table.of, field.parameter->id) != table.of.end();
        for (int i = 0; counts && i < field.components; ++i) {
            inputs.push_back(4 * static_cast<std::size_t>(place.first) + field.offset +
                             static_cast<std::size_t>(i));
        }
    }
}

/// The parameter of the table that an image changes; null: there is none.
const Parameter* texturedInput(const EffectSet& set, const Block& block, const BlockTable& table) {
    for (const std::string& id : table.of) {
        const std::string field = fieldName(id);
        const bool hasImage = std::ranges::any_of(set.textures, [&](const TextureEffect& image) {
            return image.role == TextureRole::Input && image.kind == block.kind &&
                   image.field == field;
        });
        if (hasImage) {
            return block.parameter(id);
        }
    }
    return nullptr;
}

void forgetTables(EffectSet& set, BlockUse& use, const Catalog& catalog) {
    const Block* block = catalog.find(use.kind, use.id);
    for (const AccuracyChoice& choice : block ? block->accuracy : std::vector<AccuracyChoice>()) {
        const EnumValue* level = levelOf(choice, use);
        const BlockTable* table = level == nullptr ? nullptr : block->table(level->table);
        const Parameter* changed = table ? texturedInput(set, *block, *table) : nullptr;
        if (changed != nullptr) {
            std::ranges::find(use.compiled, choice.id, &CompiledValue::id)->value =
                choice.values.front().id;
            set.leftOut.push_back({"table/" + table->id,
                                   fmt::format("An image drives {}, so {} is computed exactly.",
                                               changed->label, choice.label)});
        }
    }
}

} // namespace

void TableLayout::add(const BlockPlace& place, const BlockUse& use, TableReader reader) {
    for (const AccuracyChoice& choice : place.block->accuracy) {
        const EnumValue* level = levelOf(choice, use);
        const BlockTable* table = level == nullptr ? nullptr : place.block->table(level->table);
        if (table == nullptr || has(*table)) {
            continue;
        }
        places.push_back({place.block, table, reader, place.first, size.y});
        size = {std::max(size.x, table->size.x), size.y + table->size.y};
        addInputs(inputs, place, *table);
    }
}

bool TableLayout::has(const BlockTable& table) const {
    return std::ranges::any_of(places,
                               [&table](const TablePlace& p) { return p.table == &table; });
}

void forgetTablesOfTextured(EffectSet& set, const Catalog& catalog) {
    if (set.textures.empty()) {
        return;
    }
    if (set.model) {
        forgetTables(set, *set.model, catalog);
    }
    for (BlockUse& use : set.slots) {
        forgetTables(set, use, catalog);
    }
    if (set.blend) {
        forgetTables(set, *set.blend, catalog);
    }
}

} // namespace patina
