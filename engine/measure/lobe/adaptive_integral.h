// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <span>

#include <glm/vec3.hpp>

namespace patina {

/// Says when an adaptive integral is good enough.
struct IntegralAim {
    double tolerance = 3e-5; ///< is absolute, of the worst component
    std::size_t panels = 60; ///< limits how many panels the range is cut into
    /// Limits how many panels each ring of an integral over directions is cut into: steps of a
    /// reflectance, such as shadows of grooves, would take as many as there may be.
    std::size_t ringPanels = 128;
    /// Takes each panel once by the Gauss rule of 5 nodes, without an estimate of the uncertainty.
    bool isSketch = false;
};

/// Is an integral with an estimate of how far it may be off.
struct Integral {
    glm::dvec3 value{0.0};
    double uncertainty = 0.0; ///< is absolute, of the worst component
};

/// Integrates a function between the first and the last of the ends by the Gauss-Kronrod rule of 15
/// nodes, and halves the panel that is the least certain until the aim is reached (QUADPACK,
/// Piessens et al. 1983). The other ends are where panels begin, such as kinks; ends rise.
Integral adaptiveIntegral(const std::function<glm::dvec3(double)>& integrand,
                          std::span<const double> ends, const IntegralAim& aim);

} // namespace patina
