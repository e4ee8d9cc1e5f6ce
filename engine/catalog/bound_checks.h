// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/descriptor.h"

namespace patina {

/// Returns every mistake in a descriptor's Hiding and Reach, each at its place.
Errors boundMistakes(const Descriptor& descriptor);

} // namespace patina
