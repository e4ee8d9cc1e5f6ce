// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/image.h"

namespace patina {

/// Are the errors that colours tell apart: what errs less is black, what errs more is as bright.
inline constexpr double minErrorShown = 1e-6;
inline constexpr double greatestErrorShown = 1.0;

/// Returns the colour of a relative error, sRGB: from black by violet, red and orange to pale
/// yellow, with equal steps for equal factors; what is not a number is as bright as the worst.
glm::vec3 errorColor(double relative);

/// Returns a map of relative errors, rows from the top, as a picture of these colours, sRGB.
Image errorPicture(std::span<const double> errors, glm::ivec2 size);

} // namespace patina
