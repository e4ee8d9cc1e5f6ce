// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>

namespace patina::reference {

/// Returns how many bins the table of a measured file has: of azimuth, difference and half angle.
/// `file` is the number of the table (tableNumber()).
glm::ivec3 measuredBins(double file);

/// Returns f in 1/sr of a bin of the table.
glm::dvec3 measuredValue(double file, const glm::ivec3& bin);

} // namespace patina::reference
