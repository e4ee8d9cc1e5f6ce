// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/descriptor.h"

namespace patina {

/// Returns what keeps parameters from what the keys `transparency` (a share of the light, the same
/// wherever on the surface), `highlight` and `role` make of them, and the roles that the block
/// lacks.
Errors roleMistakes(const Descriptor& descriptor);

} // namespace patina
