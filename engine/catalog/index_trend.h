// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/block.h"

namespace patina {

namespace roles {
/// Are the temperature of a material in degrees, that at which its `indexInside` was measured, how
/// much the index rises per kelvin of itself, and how much the volume does.
inline constexpr std::string_view temperature = "temperature";
inline constexpr std::string_view temperatureMeasured = "temperatureMeasured";
inline constexpr std::string_view temperatureSlope = "temperatureSlope";
inline constexpr std::string_view expansion = "expansion";
} // namespace roles

/// Tells whether the parameter is one by which `indexInside` follows the temperature. Packers put
/// the index that results in its place, so no shader knows of them.
bool isOfIndexTrend(const Parameter& parameter);

/// Returns the index that was measured as `index` at the temperature of the block, in the range of
/// its parameter `indexInside`. Warm bodies are larger, so that less of them is on light's way:
/// (n^2 - 1)/(n^2 + 2) falls as the density does (H. A. Lorentz, Annalen der Physik 245, 1880;
/// L. Lorenz, Annalen der Physik 247, 1880; M. Born and E. Wolf, Principles of Optics, 7th edition,
/// 1999, section 2.3.3, equation 17), and dn/dT (T - T0) is added to it. A block without these
/// parameters, or with neither a slope nor an expansion, has the index itself.
double indexAtTemperature(const Block& block, const Values& values, double index);

/// Writes that index in the place of the number of `indexInside`; others keep theirs.
void takeTemperature(const Block& block, const Parameter& parameter, const Values& values,
                     double* number);

} // namespace patina
