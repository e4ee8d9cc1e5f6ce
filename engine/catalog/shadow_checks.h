// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/descriptor.h"

namespace patina {

/// Returns what a light with shadows is missing in its descriptor: a shadow map needs a position, a
/// direction or an angle, depending on its projection.
Errors shadowMistakes(const Descriptor& descriptor);

} // namespace patina
