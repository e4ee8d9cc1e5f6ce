// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/blocks_in_use.h"

#include "material/model_swap.h"

namespace patina {
namespace {

/// Returns the block chosen of a kind, or the default of the model's slot where none is; null where
/// neither is known or the chosen one does nothing with this model.
const Block* partInUse(const Material& material, const Block& model, std::string_view kind,
                       const Catalog& catalog) {
    const BlockValues* part = material.part(kind);
    const Slot* slot = model.slot(kind);
    if (part != nullptr) {
        return hasPlaceFor(model, kind) ? catalog.find(kind, part->id) : nullptr;
    }
    return slot != nullptr ? catalog.find(kind, slot->defaultBlock) : nullptr;
}

} // namespace

std::vector<const Block*> blocksInUse(const Material& material, const Catalog& catalog) {
    const Block* model = catalog.find(kinds::models, material.model.id);
    if (model == nullptr) {
        return {};
    }
    std::vector<const Block*> blocks{model};
    for (const std::string_view kind : partKinds(BlockOwner::Material)) {
        if (const Block* block = partInUse(material, *model, kind, catalog)) {
            blocks.push_back(block);
        }
    }
    return blocks;
}

} // namespace patina
