// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/descriptor.h"

namespace patina {

/// What keeps a parameter with the key `transparency` from being a share of the light, the same
/// wherever on the surface.
Errors transparencyMistakes(const Descriptor& descriptor);

} // namespace patina
