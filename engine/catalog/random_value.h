// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include "catalog/parameter.h"

namespace patina {

/// Returns a value that the parameter's slider reaches, made of numbers from 0 to 1 that `next`
/// gives; evenly along the slider, so where it is logarithmic as well. Nothing for choices, files,
/// curves, ramps, and for what glows: a look is not made of those by chance.
std::optional<Value> randomValue(const Parameter& parameter, const std::function<double()>& next);

} // namespace patina
