// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/material.h"

#include <algorithm>

#include "material/block_values.h"

namespace patina {
namespace {

/// Gives every choice of the block a level: the exact one where it has none or an unknown one.
void completeAccuracy(const Block& block, AccuracyLevels& accuracy) {
    for (const AccuracyChoice& choice : block.accuracy) {
        std::string& level = accuracy[choice.id];
        const bool known = std::any_of(choice.values.begin(), choice.values.end(),
                                       [&](const EnumValue& value) { return value.id == level; });
        if (!known) {
            level = choice.values.front().id;
        }
    }
}

/// Takes the parked values of a part out of `parked`. They have a member of their own, named by
/// their kind, since a model may use the same ids.
nlohmann::json takePool(nlohmann::json& parked, std::string_view kind) {
    const auto found = parked.find(kind);
    if (found == parked.end() || !found->is_object()) {
        return nlohmann::json::object();
    }
    nlohmann::json pool = std::move(*found);
    parked.erase(found);
    return pool;
}

void putPool(nlohmann::json pool, nlohmann::json& parked, std::string_view kind) {
    if (!pool.empty()) {
        parked[std::string(kind)] = std::move(pool);
    }
}

} // namespace

const BlockValues* partOf(const BlockParts& parts, std::string_view kind) {
    const auto found = parts.find(kind);
    return found == parts.end() ? nullptr : &found->second;
}

BlockValues* partOf(BlockParts& parts, std::string_view kind) {
    const auto found = parts.find(kind);
    return found == parts.end() ? nullptr : &found->second;
}

const Block* blockOf(const BlockParts& parts, std::string_view kind, const Catalog& catalog) {
    const BlockValues* part = partOf(parts, kind);
    return part == nullptr ? nullptr : catalog.find(kind, part->id);
}

void setPart(BlockParts& parts, std::string_view kind, std::optional<BlockValues> values) {
    if (values) {
        parts.insert_or_assign(std::string(kind), std::move(*values));
    } else if (const auto found = parts.find(kind); found != parts.end()) {
        parts.erase(found);
    }
}

Material defaultMaterial(const Block& model) {
    Material material;
    material.name = model.label;
    material.model = defaultBlockValues(model);
    completeAccuracy(model, material.accuracy);
    return material;
}

Material withModel(const Material& material, const Block* oldModel, const Block& newModel) {
    Material next = material;
    std::vector<nlohmann::json> pools;
    for (const std::string_view kind : partKinds(BlockOwner::Material)) {
        pools.push_back(takePool(next.parked, kind));
    }
    next.model = carriedOver(material.model, oldModel, newModel, next.parked);
    for (std::size_t i = 0; i < pools.size(); ++i) {
        putPool(std::move(pools[i]), next.parked, partKinds(BlockOwner::Material)[i]);
    }
    completeAccuracy(newModel, next.accuracy);
    return next;
}

Material withPart(const Material& material, std::string_view kind, const Block* oldBlock,
                  const Block* newBlock) {
    Material next = material;
    nlohmann::json pool = takePool(next.parked, kind);
    const BlockValues* held = material.part(kind);
    const BlockValues current = held == nullptr ? BlockValues{} : *held;
    if (newBlock != nullptr) {
        setPart(next.parts, kind, carriedOver(current, oldBlock, *newBlock, pool));
        completeAccuracy(*newBlock, next.accuracy);
    } else {
        park(current.parameters, pool);
        setPart(next.parts, kind, std::nullopt);
    }
    putPool(std::move(pool), next.parked, kind);
    return next;
}

} // namespace patina
