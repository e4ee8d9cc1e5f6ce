// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/descriptor.h"

namespace patina {

/// Returns the mistakes in the keys `transparency` (a share of the light, the same everywhere on
/// the surface), `highlight` and `role` of the parameters, and the needed roles that no parameter
/// has.
Errors roleMistakes(const Descriptor& descriptor);

} // namespace patina
