// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/index_trend.h"

#include <algorithm>
#include <cmath>

#include "catalog/block_kind.h"

namespace patina {
namespace {

/// Returns the number with a role as shaders would get it; 0 where there is none.
double trendNumber(const Block& block, const Values& values, std::string_view role) {
    const Parameter* parameter = block.withRole(role);
    if (parameter == nullptr) {
        return 0.0;
    }
    const auto found = values.find(parameter->id);
    double number = 0.0;
    writeNumbers(*parameter, found == values.end() ? parameter->defaultValue : found->second,
                 &number);
    return number;
}

/// Returns the index of a material whose density is so much of what it was.
double indexOfDensity(double index, double density) {
    const double square = index * index;
    const double refractivity = density * (square - 1.0) / (square + 2.0);
    const double rest = std::max(1.0 - refractivity, 1e-12);
    return std::sqrt(std::max((1.0 + 2.0 * refractivity) / rest, 0.0));
}

} // namespace

bool isOfIndexTrend(const Parameter& parameter) {
    return parameter.role == roles::temperature || parameter.role == roles::temperatureMeasured ||
           parameter.role == roles::temperatureSlope || parameter.role == roles::expansion;
}

double indexAtTemperature(const Block& block, const Values& values, double index) {
    const Parameter* inside = block.withRole(roles::indexInside);
    const double slope = trendNumber(block, values, roles::temperatureSlope);
    const double expansion = trendNumber(block, values, roles::expansion);
    const double warmer = trendNumber(block, values, roles::temperature) -
                          trendNumber(block, values, roles::temperatureMeasured);
    if (inside == nullptr || warmer == 0.0 || (slope == 0.0 && expansion == 0.0)) {
        return index;
    }
    const double density = 1.0 / std::max(1.0 + expansion * warmer, 1e-6);
    const double warm = indexOfDensity(index, density) + slope * warmer;
    return std::isfinite(warm) ? std::clamp(warm, inside->min, inside->max) : index;
}

void takeTemperature(const Block& block, const Parameter& parameter, const Values& values,
                     double* number) {
    if (parameter.role == roles::indexInside) {
        *number = indexAtTemperature(block, values, *number);
    }
}

} // namespace patina
