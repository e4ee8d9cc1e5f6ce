// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/image.h"

namespace patina {

/// Bound the errors that have different colours: smaller ones are black, larger ones have the last
/// colour.
inline constexpr double minErrorShown = 1e-6;
inline constexpr double greatestErrorShown = 1.0;

/// Returns the colour of a relative error, sRGB: from black by violet, red and orange to pale
/// yellow, with equal steps for equal factors. NaN has the last colour.
glm::vec3 errorColor(double relative);

/// Returns a map of relative errors, rows from the top, as a picture of these colours, sRGB.
Image errorPicture(std::span<const double> errors, glm::ivec2 size);

} // namespace patina
