// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/reconciled.h"

#include "material/block_values.h"

namespace patina {
namespace {

/// Tells whether the block has not changed; values from a file then stay as they are, and so do
/// those that it left out.
bool isAsItWas(const Block* before, const Block& after) {
    return before != nullptr && *before == after;
}

} // namespace

BlockValues reconciled(const BlockValues& values, std::string_view kind, const Catalog& before,
                       const Catalog& after) {
    const Block* from = before.find(kind, values.id);
    const Block* to = after.find(kind, values.id);
    if (to == nullptr || isAsItWas(from, *to)) {
        return values;
    }
    nlohmann::json parked = values.unknown.value("parked", nlohmann::json::object());
    BlockValues next = carriedOver(values, from, *to, parked);
    next.unknown.erase("parked");
    if (!parked.empty()) {
        next.unknown["parked"] = std::move(parked);
    }
    return next;
}

Material reconciled(const Material& material, const Catalog& before, const Catalog& after) {
    Material next = material;
    const Block* modelBefore = before.find(kinds::models, material.model.id);
    const Block* model = after.find(kinds::models, material.model.id);
    if (model != nullptr && !isAsItWas(modelBefore, *model)) {
        next = withModel(next, modelBefore, *model);
    }
    for (const auto& [kind, values] : material.parts) {
        const Block* partBefore = before.find(kind, values.id);
        const Block* block = after.find(kind, values.id);
        if (block != nullptr && !isAsItWas(partBefore, *block)) {
            next = withPart(next, kind, partBefore, block);
        }
    }
    return next;
}

} // namespace patina
