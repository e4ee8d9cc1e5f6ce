// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>

#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>

#include "catalog/parameter.h"
#include "catalog/value_error.h"

namespace patina {

/// A choice of a shorthand may set a vec3 of red, green and blue by a spectrum: a number for each
/// of some wavelengths, as tables of optical constants have it. It is a NumberList among
/// EnumValue::fills, of pairs of a wavelength in nm and the number, by rising wavelengths. Between
/// two of them it is linear, and beyond the first and the last it stays as it is there.

/// Returns the spectrum that a value is; null where it is none.
const NumberList* spectrumIn(const Value& value);

/// Reads what a choice sets a parameter to: its value, or for a vec3 a spectrum, {"nm": [...],
/// "values": [...]} with two or more wavelengths above 0 that rise, and as many numbers within the
/// parameter's range.
ValueReading fillFromJson(const Parameter& parameter, const nlohmann::json& json);

nlohmann::json fillJson(const Value& fill);

/// Returns the numbers at three wavelengths in nm. One that is no number counts as the shortest.
glm::dvec3 atWavelengths(const NumberList& spectrum, const glm::dvec3& nm);

/// Returns the shortest and the longest wavelength in nm for which it has a number.
std::pair<double, double> rangeOf(const NumberList& spectrum);

/// Returns the number of srgbWavelengths in the place of a spectrum; another value as it is.
Value atSrgbWavelengths(const Value& value);

} // namespace patina
