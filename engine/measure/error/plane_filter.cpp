// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/error/plane_filter.h"

#include <algorithm>

namespace patina {
namespace {

/// Returns the weighted sum around element `i` of the `count` elements that lie `stride` apart from
/// `first` on.
double sumAround(const std::vector<double>& plane, std::size_t first, std::size_t stride, int i,
                 int count, const Kernel& kernel) {
    const int radius = static_cast<int>(kernel.size() / 2);
    double sum = 0.0;
    for (int k = -radius; k <= radius; ++k) {
        const int at = std::clamp(i + k, 0, count - 1);
        sum += kernel[static_cast<std::size_t>(k + radius)] *
               plane[first + static_cast<std::size_t>(at) * stride];
    }
    return sum;
}

} // namespace

double filteredAlong(const std::vector<double>& plane, glm::ivec2 size, const Kernel& kernel,
                     std::size_t i) {
    const std::size_t x = i % static_cast<std::size_t>(size.x);
    return sumAround(plane, i - x, 1, static_cast<int>(x), size.x, kernel);
}

double filteredDown(const std::vector<double>& plane, glm::ivec2 size, const Kernel& kernel,
                    std::size_t i) {
    const auto columns = static_cast<std::size_t>(size.x);
    const auto y = static_cast<int>(i / columns);
    return sumAround(plane, i % columns, columns, y, size.y, kernel);
}

} // namespace patina
