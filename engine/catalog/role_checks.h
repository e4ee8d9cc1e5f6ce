// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/descriptor.h"

namespace patina {

/// What keeps parameters from the roles that the keys `transparency` (a share of the light, the
/// same wherever on the surface) and `highlight` give them.
Errors roleMistakes(const Descriptor& descriptor);

} // namespace patina
