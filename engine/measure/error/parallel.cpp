// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/error/parallel.h"

#include <algorithm>
#include <thread>
#include <vector>

namespace patina {

std::size_t parallelParts() {
    return std::max(std::thread::hardware_concurrency(), 1U);
}

void inParallel(
    std::size_t count,
    const std::function<void(std::size_t part, std::size_t begin, std::size_t end)>& work) {
    const std::size_t parts = parallelParts();
    std::vector<std::thread> threads;
    for (std::size_t part = 0; part < parts; ++part) {
        threads.emplace_back(work, part, count * part / parts, count * (part + 1) / parts);
    }
    for (std::thread& thread : threads) {
        thread.join();
    }
}

} // namespace patina
