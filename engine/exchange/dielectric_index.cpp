// SPDX-License-Identifier: GPL-3.0-or-later
#include "exchange/dielectric_index.h"

#include <algorithm>
#include <cmath>

namespace patina {

DielectricIndex dielectricIndexOf(const glm::dvec3& f0) {
    constexpr double largest = (39.0 / 41.0) * (39.0 / 41.0); // of an index of 40
    const double strongest = std::min(std::max({f0.x, f0.y, f0.z}), largest);
    if (strongest <= 0.0) {
        return {1.0, glm::dvec3(1.0)};
    }
    const double root = std::sqrt(strongest);
    return {(1.0 + root) / (1.0 - root), f0 / strongest};
}

} // namespace patina
