// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/descriptor.h"

namespace patina {

/// Returns what is missing for the shadows that a descriptor promises: a map looks from somewhere,
/// some way, and reaches to an angle.
Errors shadowMistakes(const Descriptor& descriptor);

} // namespace patina
