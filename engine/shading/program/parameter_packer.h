// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include "catalog/parameter_layout.h"
#include "catalog/wavelengths.h"

namespace patina {

/// Holds what values depend on that are packed: the scene around their block.
struct PackedAround {
    glm::dmat4 cameraToWorld{1.0}; ///< is a rigid transform
    glm::dvec3 wavelengths = srgbWavelengths; ///< nm, of red, green and blue
    double pixelRatio = 1.0; ///< is that of the view (View::pixelRatio)

    // NOLINTNEXTLINE(google-explicit-constructor): most blocks know only the camera
    PackedAround(const glm::dmat4& camera, const glm::dvec3& ofScene = srgbWavelengths,
                 double ofView = 1.0)
        : cameraToWorld(camera), wavelengths(ofScene), pixelRatio(ofView) {}
};

/// Writes the values of a block as packed() does, but as floats, without allocating, and with
/// camera space transformed to world space. `out` holds at least layout.floats / 4 vec4s.
void packInto(std::span<glm::vec4> out, const ParameterLayout& layout, const Values& values,
              const AccuracyLevels& levels, const PackedAround& around);

} // namespace patina
