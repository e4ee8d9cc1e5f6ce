// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "catalog/catalog.h"
#include "scene/scene.h"

namespace patina {

/// Holds blocks as they were read: equal however often they are read, until one changes.
struct ReadBlocks {
    std::vector<Block> blocks;
    /// Are hashes of each block's shader and descriptor, and last of the files that all blocks
    /// share.
    std::vector<std::uint64_t> texts;

    friend bool operator==(const ReadBlocks&, const ReadBlocks&) = default;
};

/// Returns the blocks that a scene names, and the default blocks of their slots.
ReadBlocks readBlocksOf(const Scene& scene, const Catalog& catalog);

/// Returns all blocks of a catalogue.
ReadBlocks readBlocks(const Catalog& catalog);

/// Holds the blocks that a result depends on, to tell whether they are still the same.
class KnownBlocks {
  public:
    KnownBlocks() = default;
    KnownBlocks(std::shared_ptr<const Catalog> catalog, Scene scene);

    const std::shared_ptr<const Catalog>& catalog() const { return catalog_; }

    /// Returns whether another catalogue has the same blocks. Reads no file for a catalogue that
    /// was asked about last.
    bool areIn(const std::shared_ptr<const Catalog>& catalog) const;

  private:
    std::shared_ptr<const Catalog> catalog_;
    Scene scene_;
    ReadBlocks blocks_;
    /// Is the catalogue asked about last, to which haveSame_ is the answer.
    mutable std::shared_ptr<const Catalog> asked_;
    mutable bool haveSame_ = false;
};

} // namespace patina
