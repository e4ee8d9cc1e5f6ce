// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "catalog/catalog.h"
#include "scene/scene.h"

namespace patina {

/// Blocks as they were when they were read: equal however often that happens, until one changes.
struct ReadBlocks {
    std::vector<Block> blocks;
    std::vector<std::uint64_t> texts; ///< hashes of their shaders and descriptors, the last one of
                                      ///< all they share

    friend bool operator==(const ReadBlocks&, const ReadBlocks&) = default;
};

/// The blocks that a scene names, or its parts go without.
ReadBlocks readBlocksOf(const Scene& scene, const Catalog& catalog);

/// Returns all blocks of a catalogue.
ReadBlocks readBlocks(const Catalog& catalog);

/// Knows what something was found out with: whether the same blocks are still there.
class KnownBlocks {
  public:
    KnownBlocks() = default;
    KnownBlocks(std::shared_ptr<const Catalog> catalog, Scene scene);

    const std::shared_ptr<const Catalog>& catalog() const { return catalog_; }

    /// Tells whether another catalogue has them, too. One that is the same has; no file is read
    /// then.
    bool areIn(const std::shared_ptr<const Catalog>& catalog) const;

  private:
    std::shared_ptr<const Catalog> catalog_;
    Scene scene_;
    ReadBlocks blocks_;
    mutable std::shared_ptr<const Catalog> asked_; ///< last, and what came of it
    mutable bool haveSame_ = false;
};

} // namespace patina
