// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "catalog/catalog.h"
#include "core/error.h"
#include "material/material.h"

namespace patina {

/// A block that a scene may have, and what the command line calls it: `--<kind>` chooses it, and
/// `--set <kind>.<id>=value` sets one of its parameters.
struct SceneBlock {
    std::string kind;
    BlockParts& parts;

    /// Whether an assignment of `--set` is about it.
    bool owns(const std::string& assignment) const { return assignment.starts_with(kind + '.'); }

    Result<void> assign(const std::string& assignment, const Catalog& catalog) const;
};

/// Those of the assignments that are about the block.
Result<void> assignAll(const SceneBlock& block, const std::vector<std::string>& assignments,
                       const Catalog& catalog);

/// Whether an assignment is about a block of a scene and not about an object.
bool isForScene(const std::string& assignment);

} // namespace patina
