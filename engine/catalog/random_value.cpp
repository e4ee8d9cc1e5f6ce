// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/random_value.h"

#include <algorithm>
#include <cmath>

namespace patina {
namespace {

bool isDrawn(const Parameter& parameter) {
    const ParameterTypeInfo& info = infoOf(parameter.type);
    return info.hasRange && info.function == nullptr && info.ordinary != nullptr &&
           !parameter.emission;
}

/// Returns the number at a share of the slider's length, 0 .. 1.
double alongSlider(const Parameter& parameter, double share) {
    const double low = parameter.softMin;
    const double high = parameter.softMax;
    const bool isLog = parameter.scale == Scale::Log && low > 0.0;
    const double number = isLog ? low * std::pow(high / low, share) : low + (high - low) * share;
    return std::clamp(number, parameter.min, parameter.max);
}

} // namespace

std::optional<Value> randomValue(const Parameter& parameter, const std::function<double()>& next) {
    if (!isDrawn(parameter)) {
        return std::nullopt;
    }
    const auto number = [&] { return alongSlider(parameter, next()); };
    return conformed(parameter, infoOf(parameter.type).ordinary(parameter, number));
}

} // namespace patina
