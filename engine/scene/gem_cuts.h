// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh.h"

namespace patina {

/// Returns a round brilliant of 57 facets and a girdle of 32, of radius 1, its table up: the table
/// 53 % of the width, the crown at 34.5 degrees, the pavilion at 40.75 (M. Tolkowsky, Diamond
/// Design, 1919), with a thin girdle, stars of half the way and lower halves of 77 % of the way.
Mesh roundBrilliant();

/// Returns an emerald cut of 49 facets and a girdle of 8, two metres long, its table up: three
/// steps above the girdle and three below, along four sides and four cut corners.
Mesh emeraldCut();

} // namespace patina
