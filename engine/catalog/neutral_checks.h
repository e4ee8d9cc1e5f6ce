// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/descriptor.h"

namespace patina {

/// Returns every mistake in the conditions under which a descriptor's block does nothing
/// (NeutralCase), each at its place: ids that do not exist, conditions that always hold, and
/// repeated ones.
Errors neutralMistakes(const Descriptor& descriptor);

} // namespace patina
