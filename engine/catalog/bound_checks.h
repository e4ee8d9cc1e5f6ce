// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/descriptor.h"

namespace patina {

/// Every mistake in what a descriptor says of how far its block works (Hiding, Reach), each at its
/// place.
Errors boundMistakes(const Descriptor& descriptor);

} // namespace patina
