// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "measure/time/growth_law.h"

namespace patina {

/// Holds the time of a frame by the number of one thing.
struct ScalingCurve {
    enum class Axis { Pixels, Lights, Objects };

    Axis axis = Axis::Pixels;
    std::vector<GrowthSample> samples; ///< have rising counts
    std::optional<GrowthLaw> law;      ///< is empty where there are too few samples

    friend bool operator==(const ScalingCurve&, const ScalingCurve&) = default;
};

/// Returns "pixels", "lights" or "objects".
std::string axisText(ScalingCurve::Axis axis);

/// Writes a number. `digits` follow the point for the format 'f'; for 'g' they are significant
/// digits, without an exponent and without trailing zeros.
using NumberText = std::function<std::string(double number, char format, int digits)>;

/// Writes a number with a decimal point, whatever the user's language.
std::string plainNumber(double number, char format, int digits);

/// Returns the law in words: "linear: 1.2 ms + 34.5 ms per million pixels, R² 0.998", or "twice the
/// pixels take 1.79 times as long; a straight line has R² 0.95".
std::string lawText(const ScalingCurve& curve, const NumberText& number = plainNumber);

/// Return the curves as tables for users, as CSV with a line of names, and as JSON.
std::string scalingText(const std::vector<ScalingCurve>& curves);
std::string scalingCsv(const std::vector<ScalingCurve>& curves);
nlohmann::json scalingJson(const std::vector<ScalingCurve>& curves);

} // namespace patina
