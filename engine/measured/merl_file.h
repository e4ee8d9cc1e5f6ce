// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string_view>

#include "core/error.h"
#include "measured/measured_reflectance.h"

namespace patina {

/// Reads the bytes of a MERL file: three counts, then doubles of red, green and blue over the half
/// angle (its bins grow with the square), the difference angle and the difference azimuth (0 .. pi;
/// the reflectance is reciprocal). A value belongs to the middle of its bin. Negative ones mark
/// directions that were not measured.
Result<std::shared_ptr<const MeasuredReflectance>> merlReflectance(std::string_view bytes);

} // namespace patina
