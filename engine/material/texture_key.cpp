// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/texture_key.h"

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "catalog/settings.h"
#include "catalog/suggestion.h"

namespace patina {
namespace {

/// Collects the keys under which a material takes images.
struct Keys {
    std::vector<std::string> known;
    bool isWhole = true; ///< is false where a block of the material is not known

    void add(const Block& block, const std::string& prefix) {
        for (const Parameter& parameter : block.parameters) {
            if (!parameter.textureChannels.empty()) {
                known.push_back(prefix + parameter.id);
            }
        }
    }
};

/// Returns the id of the block that is chosen of a kind, or the default of the model's slot; empty
/// where there is neither.
std::string partId(std::string_view kind, const Block& model, const Material& material) {
    if (const BlockValues* part = material.part(kind)) {
        return part->id;
    }
    const Slot* slot = model.slot(kind);
    return slot == nullptr ? std::string() : slot->defaultBlock;
}

Keys keysOf(const Material& material, const Catalog& catalog) {
    Keys keys;
    const Block* model = catalog.find(kinds::models, material.model.id);
    keys.isWhole = model != nullptr;
    if (model == nullptr) {
        return keys;
    }
    keys.add(*settingsBlock(settings::material), {});
    keys.add(*model, {});
    for (const std::string_view kind : partKinds(BlockOwner::Material)) {
        const std::string id = partId(kind, *model, material);
        const Block* part = id.empty() ? nullptr : catalog.find(kind, id);
        keys.isWhole = keys.isWhole && (part != nullptr || id.empty());
        if (part != nullptr) {
            keys.add(*part, std::string(kind) + '.');
        }
    }
    return keys;
}

} // namespace

std::optional<Error> whyNoImage(std::string_view key, const Material& material,
                                const Catalog& catalog) {
    const Keys keys = keysOf(material, catalog);
    if (!keys.isWhole || std::find(keys.known.begin(), keys.known.end(), key) != keys.known.end()) {
        return std::nullopt;
    }
    return Error{{},
                 0,
                 0,
                 fmt::format("the material has no value \"{}\" that takes an image; it is kept as "
                             "it is",
                             key),
                 oneOf(key, keys.known)};
}

} // namespace patina
