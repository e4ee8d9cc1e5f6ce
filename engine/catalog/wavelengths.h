// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>

#include "catalog/parameter.h"

namespace patina {

/// Are the wavelengths in nm that stand for red, green and blue where a scene names no others: the
/// dominant ones of the primaries of sRGB (IEC 61966-2-1), where lines from its white, D65, through
/// them meet the pure colours of the CIE's observer of 1931. They are floats, as files hold them.
inline constexpr glm::dvec3 srgbWavelengths{611.4f, 549.1f, 464.3f};

/// Is the shortest wavelength in nm that a block is given; shorter ones mean those of the scene.
inline constexpr double minWavelength = 100.0;

/// Returns how many of a parameter's unit, nm or µm, a nm is.
double nmInUnit(const Parameter& wavelengths);

/// Replaces what is below minWavelength by the scene's wavelengths (nm), where the parameter has
/// the role of wavelengths; other parameters keep their numbers. Its unit is nm or µm.
void takeWavelengths(const Parameter& parameter, const glm::dvec3& ofScene, double* numbers);

/// Returns the wavelength that light of `wavelength`, in nm, has where these stand for red, green
/// and blue in place of srgbWavelengths: piecewise linear between the three, moved alike beyond.
double movedWavelength(double wavelength, const glm::dvec3& ofScene);

} // namespace patina
