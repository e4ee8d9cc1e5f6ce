// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "core/value.h"

namespace patina {

/// Tells how a ramp interpolates between two stops, in linear light.
enum class RampInterpolation {
    Linear,  ///< mixes linearly
    Smooth,  ///< mixes by smoothstep: slowly at both stops
    Constant ///< keeps the colour up to a step at the next stop, which is a thousandth wide
};

/// Is a colour at a place from 0 to 1.
struct RampStop {
    double at = 0.0;
    glm::dvec3 color{0.0}; ///< linear Rec. 709

    friend bool operator==(const RampStop&, const RampStop&) = default;
};

/// Holds colours along a line. Before the first stop and after the last the colour is constant.
struct Ramp {
    RampInterpolation interpolation = RampInterpolation::Linear;
    std::vector<RampStop> stops{}; ///< are sorted by rising place

    /// Returns the colour at a place, as the shader computes it. It is black without a stop.
    glm::dvec3 at(double x) const;

    friend bool operator==(const Ramp&, const Ramp&) = default;
};

inline constexpr std::size_t maxRampStops = 16;

/// Is the smallest distance between two stops.
inline constexpr double minRampGap = 0.001;

/// Returns the ramp that a value holds; it has no stops where the value is no ramp.
Ramp rampOf(const Value& value);

Value rampValue(const Ramp& ramp);

/// Returns the word that files use: "smooth".
std::string_view wordOf(RampInterpolation interpolation);

} // namespace patina
