// SPDX-License-Identifier: GPL-3.0-or-later
// Locked values: what changes a whole group at once (random values, a reset, a paste) leaves them
// alone. Files keep them with what they belong to.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "document/document.h"

namespace patina {

/// Returns the ids of the values that are locked, in order.
std::vector<std::string> lockedValues(const DocumentState& state, const BlockPath& path);
bool isLocked(const DocumentState& state, const BlockPath& path, std::string_view parameterId);

/// Stores them in what the path lies in; nothing happens where that is not there.
void storeLockedValues(DocumentState& state, const BlockPath& path,
                       const std::vector<std::string>& ids);

/// Locks values or frees them, as one undo step.
void setLocked(Document& document, const BlockPath& path, const std::vector<std::string>& ids,
               bool isLocked);

} // namespace patina
