// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "core/value.h"

namespace patina {

/// Tells how a ramp comes from one stop to the next, in linear light.
enum class RampInterpolation {
    Linear,  ///< evenly
    Smooth,  ///< slowly at both stops (smoothstep)
    Constant ///< in a step at the next stop, a thousandth wide
};

/// A colour at a place from 0 to 1.
struct RampStop {
    double at = 0.0;
    glm::dvec3 color{0.0}; ///< linear Rec. 709

    friend bool operator==(const RampStop&, const RampStop&) = default;
};

/// Colours along a line. Before the first stop and after the last it stays as they are.
struct Ramp {
    RampInterpolation interpolation = RampInterpolation::Linear;
    std::vector<RampStop> stops{}; ///< by rising place

    /// The colour at a place, as the shader has it. Black without a stop.
    glm::dvec3 at(double x) const;

    friend bool operator==(const Ramp&, const Ramp&) = default;
};

inline constexpr std::size_t maxRampStops = 16;

/// How far apart two stops are at least.
inline constexpr double minRampGap = 0.001;

/// The ramp that a value holds; without stops where it is none.
Ramp rampOf(const Value& value);

Value rampValue(const Ramp& ramp);

/// "smooth", as files have it.
std::string_view wordOf(RampInterpolation interpolation);

} // namespace patina
