// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include "catalog/parameter.h"

namespace patina {

/// Returns a value that the parameter's slider reaches, made of numbers from 0 to 1 that `next`
/// gives. It is evenly distributed along the slider, also where that is logarithmic. Choices,
/// files, curves, ramps and emission give nothing: a look is not made of those by chance.
std::optional<Value> randomValue(const Parameter& parameter, const std::function<double()>& next);

} // namespace patina
