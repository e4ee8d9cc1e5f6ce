// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>

namespace patina {

/// Calls work(part, begin, end) for every part of 0 .. count, as many parts as there are cores,
/// each on a thread of its own, and returns when all are done. `work` must not throw.
void inParallel(
    std::size_t count,
    const std::function<void(std::size_t part, std::size_t begin, std::size_t end)>& work);

/// Returns the number of parts that inParallel() makes.
std::size_t parallelParts();

} // namespace patina
