// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "measure/time/growth_law.h"

namespace patina {

/// Holds what a frame takes for more and more of one thing.
struct ScalingCurve {
    enum class Axis { Pixels, Lights, Objects };

    Axis axis = Axis::Pixels;
    std::vector<GrowthSample> samples; ///< counts rise
    std::optional<GrowthLaw> law;      ///< of the samples, where there are enough

    friend bool operator==(const ScalingCurve&, const ScalingCurve&) = default;
};

/// "pixels", "lights", "objects".
std::string axisText(ScalingCurve::Axis axis);

/// Says how a number is written: with so many digits, after the point for 'f', that count for 'g',
/// which has no exponent and no zeros at its end.
using NumberText = std::function<std::string(double number, char format, int digits)>;

/// Writes a number as programs do, with a point.
std::string plainNumber(double number, char format, int digits);

/// Returns the law in words: "linear: 1.2 ms + 34.5 ms per million pixels, R² 0.998", or "twice the
/// pixels take 1.79 times as long; a straight line has R² 0.95".
std::string lawText(const ScalingCurve& curve, const NumberText& number = plainNumber);

/// For people, as lines with a line of names before them, and for programs.
std::string scalingText(const std::vector<ScalingCurve>& curves);
std::string scalingCsv(const std::vector<ScalingCurve>& curves);
nlohmann::json scalingJson(const std::vector<ScalingCurve>& curves);

} // namespace patina
