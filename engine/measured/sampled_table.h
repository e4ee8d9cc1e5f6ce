// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "measured/measured_reflectance.h"

namespace patina {

/// Returns the reflectance in the middles of 180 x 90 x 90 bins, averaged over so many azimuths of
/// the half vector and over both orders of the directions. Where one of both directions is below
/// the surface nothing was measured. It takes as many threads as the machine has cores.
HalfDifferenceTable sampledTable(const MeasuredReflectance& measured, int turns);

} // namespace patina
