// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec2.hpp>

namespace patina {

/// Holds weights for the pixels from -r to r around one.
using Kernel = std::vector<double>;

/// Returns pixel `i` of a plane filtered along its row, or down its column. Beyond its edges the
/// plane continues with its border values.
double filteredAlong(const std::vector<double>& plane, glm::ivec2 size, const Kernel& kernel,
                     std::size_t i);
double filteredDown(const std::vector<double>& plane, glm::ivec2 size, const Kernel& kernel,
                    std::size_t i);

} // namespace patina
