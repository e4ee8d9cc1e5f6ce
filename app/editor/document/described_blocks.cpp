// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/described_blocks.h"

#include "document/accuracy_block.h"
#include "document/picture_parameters.h"
#include "material/blocks_in_use.h"

namespace patina {

DescribedBlocks::DescribedBlocks() {
    for (const Descriptor& descriptor : settingsDescriptors()) {
        settings_.emplace(descriptor.block.id, descriptor.block);
    }
    for (const Parameter& parameter : pictureAccuracyParameters()) {
        settings_.find(settings::scene)->second.parameters.push_back(parameter);
    }
}

const Block* DescribedBlocks::find(const DocumentState& state, const BlockPath& path,
                                   const Catalog& catalog) {
    if (const auto found = settings_.find(path.kind); found != settings_.end()) {
        return &found->second;
    }
    if (!path.isAt(settings::accuracy)) {
        const BlockValues* values = blockValuesAt(state, path);
        return values ? catalog.find(path.kind, values->id) : nullptr;
    }
    const Material* material = materialAt(state, path.index, path.side);
    if (!material || !find(state, pathOf(kinds::models, path.index, path.side), catalog)) {
        return nullptr;
    }
    const std::vector<const Block*> blocks = blocksInUse(*material, catalog);
    const auto known = accuracy_.find(blocks);
    return known != accuracy_.end()
               ? &known->second
               : &accuracy_.emplace(blocks, accuracyBlock(blocks)).first->second;
}

} // namespace patina
