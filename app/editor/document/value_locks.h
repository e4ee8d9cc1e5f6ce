// SPDX-License-Identifier: GPL-3.0-or-later
// Values can be locked: what changes a whole group at once (random values, a reset, a paste) leaves
// locked ones alone. Files keep the locks with what they belong to.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "document/document.h"

namespace patina {

/// Returns the ids of the locked values of a block, in order.
std::vector<std::string> lockedValues(const DocumentState& state, const BlockPath& path);
bool isLocked(const DocumentState& state, const BlockPath& path, std::string_view parameterId);

/// Stores the ids of a block's locked values in what the path lies in; does nothing where that is
/// missing.
void storeLockedValues(DocumentState& state, const BlockPath& path,
                       const std::vector<std::string>& ids);

/// Locks or unlocks values, as one undo step.
void setLocked(Document& document, const BlockPath& path, const std::vector<std::string>& ids,
               bool isLocked);

} // namespace patina
