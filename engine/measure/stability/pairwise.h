// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace patina {

/// Returns rows of choices such that every two choices of two different factors meet in some row.
/// `counts[i]` >= 1 is the number of choices of factor i; the first row is all 0. The number of
/// rows is close to the product of the two largest counts. Equal counts give equal rows.
std::vector<std::vector<std::size_t>> pairwiseRows(std::span<const std::size_t> counts);

} // namespace patina
