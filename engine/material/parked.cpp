// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/parked.h"

#include <algorithm>

namespace patina {
namespace {

using Json = nlohmann::json;

constexpr const char* parkedKey = "parked"; ///< holds a part's own parked values

using Blocks = std::map<std::string, const Block*, std::less<>>;

/// Returns the material's blocks by kind; a block is null where the catalogue does not know it.
Blocks blocksOf(const Material& material, const Catalog& catalog) {
    Blocks blocks;
    blocks[std::string(kinds::models)] = catalog.find(kinds::models, material.model.id);
    for (const auto& [kind, values] : material.parts) {
        blocks[kind] = catalog.find(kind, values.id);
    }
    return blocks;
}

bool isChoiceOf(const Blocks& blocks, const std::string& id) {
    return std::ranges::any_of(
        blocks, [&id](const auto& block) { return block.second->accuracyChoice(id) != nullptr; });
}

bool isChoiceOfAny(const Catalog& catalog, const std::string& id) {
    return std::ranges::any_of(
        catalog.blocks, [&id](const Block& block) { return block.accuracyChoice(id) != nullptr; });
}

/// Returns those parked values whose ids are the block's own parameters.
Json ownOf(const Json& parked, const Block& block) {
    Json own = Json::object();
    for (const auto& [id, value] : parked.items()) {
        if (block.parameter(id) != nullptr) {
            own[id] = value;
        }
    }
    return own;
}

/// Returns those parked values that the blocks may use, with the values of parts in members named
/// by their kinds.
Json ownOf(const Json& parked, const Blocks& blocks) {
    Json own = ownOf(parked, *blocks.at(std::string(kinds::models)));
    for (const auto& [key, value] : parked.items()) {
        if (isChoiceOf(blocks, key)) {
            own[key] = value;
        }
        const auto part = key == kinds::models ? blocks.end() : blocks.find(key);
        if (part == blocks.end() || !value.is_object()) {
            continue;
        }
        if (Json ofPart = ownOf(value, *part->second); !ofPart.empty()) {
            own[key] = std::move(ofPart);
        }
    }
    return own;
}

void dropFromPart(BlockValues& part, const Block& block) {
    const auto found = part.unknown.find(parkedKey);
    if (found == part.unknown.end() || !found->is_object()) {
        return;
    }
    Json own = ownOf(*found, block);
    if (own.empty()) {
        part.unknown.erase(found);
    } else {
        *found = std::move(own);
    }
}

} // namespace

Material withoutParked(const Material& material, const Catalog& catalog) {
    const Blocks blocks = blocksOf(material, catalog);
    if (std::ranges::any_of(blocks, [](const auto& block) { return block.second == nullptr; })) {
        return material;
    }
    Material kept = material;
    kept.parked = ownOf(material.parked, blocks);
    for (auto& [kind, part] : kept.parts) {
        dropFromPart(part, *blocks.at(kind));
    }
    std::erase_if(kept.accuracy, [&](const auto& level) {
        return !isChoiceOf(blocks, level.first) && isChoiceOfAny(catalog, level.first);
    });
    return kept;
}

} // namespace patina
