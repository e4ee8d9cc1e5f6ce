// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "catalog/catalog.h"
#include "core/error.h"
#include "material/material.h"

namespace patina {

/// "id=value" of `--set`, cut in two.
struct Assignment {
    std::string id;
    std::string text; ///< of the value

    /// Returns what follows "<word>." in the id; empty where the id begins otherwise.
    std::string inside(std::string_view word) const;
};

Result<Assignment> assignmentFrom(const std::string& text);

/// Sets a parameter of a block, and what it sets with it; false when the block has none of this id.
Result<bool> assignIn(const Block& block, Values& values, const Assignment& assignment);

/// Returns the ids of a block's parameters, each after a prefix.
std::vector<std::string> parameterIds(const Block& block, const std::string& prefix = {});

/// Returns the kind that files call so; null where there is none.
const BlockKind* kindCalled(std::string_view singular);

/// Returns the block of a kind with this id; the error names those that there are, and the nearest
/// of them.
Result<const Block*> knownBlock(const Catalog& catalog, std::string_view kind,
                                const std::string& id);

} // namespace patina
