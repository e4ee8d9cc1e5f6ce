// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/stability/edge_case_values.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace patina {
namespace {

/// Returns the next float; above 0 the smallest normal one, because devices flush smaller ones to
/// 0.
double nextFloat(double x) {
    using Limits = std::numeric_limits<float>;
    return x == 0.0
               ? static_cast<double>(Limits::min())
               : static_cast<double>(std::nextafter(static_cast<float>(x), Limits::infinity()));
}

/// Returns the edge cases of a number in order of importance, without those outside the range.
std::vector<double> edgeCaseNumbers(const Parameter& parameter) {
    std::vector<double> numbers{parameter.min,
                                parameter.max,
                                0.0,
                                parameter.softMin,
                                parameter.softMax,
                                nextFloat(parameter.min),
                                nextFloat(0.0),
                                1e-25};
    numbers.insert(numbers.end(), {nextFloat(parameter.softMin), parameter.softMin + parameter.step,
                                   parameter.softMax + parameter.step});
    numbers.insert(numbers.end(), {1.0, 1e-4, 1.0 + 1e-6, 1.5, 1e3, 1e5, 1e-3, 0.05, 10.0, 100.0,
                                   1.0 - 1e-6, 0.5});
    std::vector<double> legal;
    for (const double number : numbers) {
        const auto rounded = static_cast<double>(static_cast<float>(number));
        const bool inside = rounded >= parameter.min && rounded <= parameter.max;
        if (inside && std::find(legal.begin(), legal.end(), rounded) == legal.end()) {
            legal.push_back(rounded);
        }
    }
    return legal;
}

} // namespace

std::vector<Value> edgeCaseValues(const Parameter& parameter) {
    std::vector<Value> values{roundedToFloat(parameter.defaultValue)};
    for (const Value& value :
         infoOf(parameter.type).edgeCases(parameter, edgeCaseNumbers(parameter))) {
        const Value legal = roundedToFloat(conformed(parameter, value));
        if (std::find(values.begin(), values.end(), legal) == values.end()) {
            values.push_back(legal);
        }
    }
    return values;
}

} // namespace patina
