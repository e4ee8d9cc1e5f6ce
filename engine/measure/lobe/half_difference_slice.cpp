// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/lobe/half_difference_slice.h"

#include <cmath>
#include <numbers>

namespace patina {

double HalfDifferenceSlice::angleOf(int cell) const {
    return 0.5 * std::numbers::pi * (cell + 0.5) / size;
}

HalfDifferenceSlice halfDifferenceSlice(const LobeModel& model, int size) {
    HalfDifferenceSlice slice{size, {}};
    slice.cells.reserve(static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
    for (int row = 0; row < size; ++row) {
        const double difference = slice.angleOf(row);
        const double sd = std::sin(difference);
        const double cd = std::cos(difference);
        for (int column = 0; column < size; ++column) {
            const double half = slice.angleOf(column);
            const glm::dvec3 l(std::sin(half) * cd, sd, std::cos(half) * cd);
            slice.cells.push_back(model.reflectance(l, {l.x, -sd, l.z}));
        }
    }
    return slice;
}

} // namespace patina
