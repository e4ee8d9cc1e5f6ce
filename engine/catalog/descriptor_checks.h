// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "catalog/descriptor.h"

namespace patina {

/// The mistakes in a descriptor that a schema cannot see: ranges, defaults, names used twice,
/// conditions over parameters that are not there, a missing shader. A part that the schema already
/// rejects is passed over.
Errors descriptorMistakes(const Descriptor& descriptor);

/// Returns the ids of the blocks of a kind.
using IdsOfKind = std::function<std::vector<std::string>(const std::string& kind)>;

/// The slots whose default is no block that there is.
Errors slotMistakes(const Descriptor& descriptor, const IdsOfKind& idsOfKind);

} // namespace patina
