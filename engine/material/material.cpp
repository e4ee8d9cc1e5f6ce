// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/material.h"

#include <algorithm>

#include "material/block_values.h"

namespace patina {
namespace {

constexpr const char* fresnelPool = "fresnel"; ///< member of `parked`: values of Fresnel blocks

/// Every choice of the block gets a level, the exact one where none fits.
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

/// The values of Fresnel blocks are parked by themselves: their ids may be a model's, too.
nlohmann::json takeFresnelPool(nlohmann::json& parked) {
    const auto found = parked.find(fresnelPool);
    if (found == parked.end() || !found->is_object()) {
        return nlohmann::json::object();
    }
    nlohmann::json pool = std::move(*found);
    parked.erase(fresnelPool);
    return pool;
}

void putFresnelPool(nlohmann::json pool, nlohmann::json& parked) {
    if (!pool.empty()) {
        parked[fresnelPool] = std::move(pool);
    }
}

} // namespace

Material defaultMaterial(const Block& model) {
    Material material;
    material.name = model.label;
    material.model = defaultBlockValues(model);
    completeAccuracy(model, material.accuracy);
    return material;
}

Material withModel(const Material& material, const Block* oldModel, const Block& newModel) {
    Material next = material;
    nlohmann::json pool = takeFresnelPool(next.parked);
    next.model = carriedOver(material.model, oldModel, newModel, next.parked);
    putFresnelPool(std::move(pool), next.parked);
    completeAccuracy(newModel, next.accuracy);
    return next;
}

Material withFresnel(const Material& material, const Block* oldBlock, const Block* newBlock) {
    Material next = material;
    nlohmann::json pool = takeFresnelPool(next.parked);
    const BlockValues current = material.fresnel.value_or(BlockValues{});
    if (newBlock != nullptr) {
        next.fresnel = carriedOver(current, oldBlock, *newBlock, pool);
        completeAccuracy(*newBlock, next.accuracy);
    } else {
        park(current.parameters, pool);
        next.fresnel.reset();
    }
    putFresnelPool(std::move(pool), next.parked);
    return next;
}

} // namespace patina
