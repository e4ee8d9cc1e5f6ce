// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "measured/measured_reflectance.h"

namespace patina {

/// Returns the reflectance in the middles of a table's bins, averaged over both orders of the
/// directions: 180 x 90 x 90 bins, in which a surface with a grain is averaged over eight azimuths
/// of the half vector, or grainTurns times 20 x 32 x 64. Where one of both directions is below the
/// surface nothing was measured. It takes as many threads as the machine has cores.
HalfDifferenceTable sampledTable(const MeasuredReflectance& measured, TableForm form);

} // namespace patina
