// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/descriptor.h"

namespace patina {

/// Every mistake in what a descriptor says of when its block does nothing (NeutralCase), each at
/// its place: what names nothing, what always holds, so that the block were never there, and what
/// is said twice.
Errors neutralMistakes(const Descriptor& descriptor);

} // namespace patina
