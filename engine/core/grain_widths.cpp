// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grain_widths.h"

#include <cmath>
#include <numbers>

#include <glm/trigonometric.hpp>

namespace patina {
namespace {

constexpr double maxGrainShare = 0.9; // is how much of the ratio an anisotropy of 1 takes

} // namespace

GrainWidths widthsOf(const GrainShape& shape) {
    const double aspect = std::sqrt(1.0 - maxGrainShare * shape.anisotropy);
    return {shape.alpha / aspect, shape.alpha * aspect};
}

GrainShape shapeOf(const GrainWidths& widths) {
    return {std::sqrt(widths.along * widths.across),
            (1.0 - widths.along / widths.across) / maxGrainShare};
}

double grainAcross(double angle) {
    const double degrees = std::fmod(glm::degrees(angle) + 90.0, 180.0);
    return degrees < 0.0 ? degrees + 180.0 : degrees;
}

double streakAcross(double degrees) {
    return std::remainder(glm::radians(degrees) + 0.5 * std::numbers::pi, std::numbers::pi);
}

} // namespace patina
