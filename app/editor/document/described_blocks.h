// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "catalog/catalog.h"
#include "document/document_state.h"

namespace patina {

/// Finds the descriptor of what is at a path: a block of the catalogue, settings, or the accuracy
/// of a material, whose descriptor is made of the blocks that it uses.
class DescribedBlocks {
  public:
    DescribedBlocks();

    /// Returns null where nothing is at the path, or where its block is not known.
    const Block* find(const DocumentState& state, const BlockPath& path, const Catalog& catalog);

    /// Drops what was made of the catalogue's blocks; called when these have changed.
    void forget() { accuracy_.clear(); }

  private:
    std::map<std::string, Block, std::less<>> settings_;
    std::map<std::vector<const Block*>, Block> accuracy_; ///< is keyed by the blocks in use
};

} // namespace patina
