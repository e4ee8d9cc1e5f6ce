// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <glm/vec2.hpp>

namespace patina {

/// Weights for the pixels from -r to r around one.
using Kernel = std::vector<double>;

/// A plane filtered along its rows with one kernel and along its columns with another; beyond the
/// edges it goes on as it ends.
std::vector<double> filtered(const std::vector<double>& plane, glm::ivec2 size,
                             const Kernel& along, const Kernel& down);

} // namespace patina
