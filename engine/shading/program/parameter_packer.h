// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include "catalog/parameter_layout.h"

namespace patina {

/// Writes the values of a block as packed() does, but as floats, without allocating, and with
/// camera space transformed to world space. `out` holds at least layout.floats / 4 vec4s.
/// `cameraToWorld` is a rigid transform.
void packInto(std::span<glm::vec4> out, const ParameterLayout& layout, const Values& values,
              const AccuracyLevels& levels, const glm::dmat4& cameraToWorld);

} // namespace patina
