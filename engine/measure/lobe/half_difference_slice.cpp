// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/lobe/half_difference_slice.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/color.h"

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

double whiteOf(std::span<const HalfDifferenceSlice* const> slices) {
    constexpr double darkerShare = 0.95;
    std::vector<double> strongest;
    for (const HalfDifferenceSlice* slice : slices) {
        for (const glm::dvec3& f : slice->cells) {
            strongest.push_back(std::max({f.x, f.y, f.z}));
        }
    }
    if (strongest.empty()) {
        return 0.0;
    }
    std::ranges::sort(strongest);
    const double white = strongest[static_cast<std::size_t>(
        darkerShare * static_cast<double>(strongest.size() - 1))];
    return white > 0.0 ? white : strongest.back(); // a thin highlight on black is all there is
}

glm::dvec3 shownColor(const glm::dvec3& f, LobeScale scale, double white) {
    glm::dvec3 color;
    for (int channel = 0; channel < 3; ++channel) {
        color[channel] = lobeLength(scale, std::min(f[channel], white), white);
    }
    return scale == LobeScale::Linear ? srgbEncoded(color) : color;
}

} // namespace patina
