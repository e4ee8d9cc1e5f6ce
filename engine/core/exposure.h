// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

namespace patina {

inline constexpr double maxStops = 32.0; ///< EV, limits the exposure in both directions

/// Returns what linear light is multiplied by at an exposure in powers of two, which is held within
/// maxStops.
inline double exposureFactor(double stops) {
    return std::exp2(std::clamp(stops, -maxStops, maxStops));
}

} // namespace patina
