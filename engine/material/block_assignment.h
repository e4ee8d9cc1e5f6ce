// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "catalog/catalog.h"
#include "core/error.h"
#include "material/material.h"

namespace patina {

/// Holds the two halves of "id=value", as `--set` takes it.
struct Assignment {
    std::string id;
    std::string text; ///< is the value as it was typed

    /// Returns what follows "<word>." in the id; empty where the id begins otherwise.
    std::string inside(std::string_view word) const;
};

Result<Assignment> assignmentFrom(const std::string& text);

/// Sets a parameter of a block, and the others that it sets. Returns false where the block has no
/// parameter of this id, and an error where the text is no value of it.
Result<bool> assignIn(const Block& block, Values& values, const Assignment& assignment);

/// Returns the ids of a block's parameters, each after a prefix.
std::vector<std::string> parameterIds(const Block& block, const std::string& prefix = {});

/// Returns the kind by its word in files, as "light"; null where there is none.
const BlockKind* kindCalled(std::string_view singular);

/// Returns the block of a kind with this id. The error names those that exist, and the nearest one.
Result<const Block*> knownBlock(const Catalog& catalog, std::string_view kind,
                                const std::string& id);

} // namespace patina
