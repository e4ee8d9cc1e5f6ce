// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/reconciled.h"

#include "material/block_values.h"

namespace patina {

BlockValues reconciled(const BlockValues& values, std::string_view kind, const Catalog& before,
                       const Catalog& after) {
    const Block* to = after.find(kind, values.id);
    if (to == nullptr) {
        return values;
    }
    nlohmann::json parked = values.unknown.value("parked", nlohmann::json::object());
    BlockValues next = carriedOver(values, before.find(kind, values.id), *to, parked);
    next.unknown.erase("parked");
    if (!parked.empty()) {
        next.unknown["parked"] = std::move(parked);
    }
    return next;
}

Material reconciled(const Material& material, const Catalog& before, const Catalog& after) {
    Material next = material;
    if (const Block* model = after.find("models", material.model.id)) {
        next = withModel(next, before.find("models", material.model.id), *model);
    }
    for (const auto& [kind, values] : material.parts) {
        if (const Block* block = after.find(kind, values.id)) {
            next = withPart(next, kind, before.find(kind, values.id), block);
        }
    }
    return next;
}

} // namespace patina
