// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "catalog/descriptor.h"

namespace patina {

/// Returns the mistakes in a descriptor that a schema cannot find: ranges, defaults, names used
/// twice, conditions over missing parameters, a missing shader. A part that the schema already
/// rejects is skipped.
Errors descriptorMistakes(const Descriptor& descriptor);

/// Returns the ids of the blocks of a kind.
using IdsOfKind = std::function<std::vector<std::string>(const std::string& kind)>;

/// Returns an error for each slot whose default block does not exist.
Errors slotMistakes(const Descriptor& descriptor, const IdsOfKind& idsOfKind);

} // namespace patina
