// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "material/material.h"

namespace patina {

/// Returns the material without what only other blocks than its own would use: values that are
/// parked for them, and levels of their accuracy choices. A parked value stays where a block of the
/// material has a parameter of its id and could not use it as it came. Everything stays while one
/// of the blocks is missing from the catalogue.
Material withoutParked(const Material& material, const Catalog& catalog);

} // namespace patina
