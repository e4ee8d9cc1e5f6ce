// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "material/material.h"

namespace patina {

/// Returns the material without what only other blocks than its own would use: values that are
/// parked for them, and levels of their accuracy choices. A parked value that stands for one which
/// a block of the material could not use as it came stays, and so does everything while the
/// catalogue lacks one of the blocks.
Material withoutParked(const Material& material, const Catalog& catalog);

} // namespace patina
