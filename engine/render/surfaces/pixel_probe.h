// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <glm/vec3.hpp>

namespace patina {

/// Names the defects that the numerical check finds in a pixel; of several the last one is shown.
/// The numbers are those of shaders/passes/inspection.glsl.
enum class PixelDefect { None, AboveOne, Negative, Infinite, NotANumber };

/// Holds the light that one light source sends to the viewer from a point.
struct LightShare {
    std::size_t light = 0; ///< is its index in the scene
    glm::vec3 value{0.0f}; ///< is its light times the model's value, before that is clamped to 0
    float nl = 0.0f;       ///< is the cosine between its direction and the normal
};

/// Holds a colour after blending, and the share by which it was blended.
struct BlendedColor {
    glm::vec3 value{0.0f};
    float share = 0.0f;
};

/// Holds the numbers of one pixel as the shader computed them, linear and before exposure. A term
/// that the program does not have is empty.
struct PixelProbe {
    std::size_t object = 0; ///< is its index in the scene
    PixelDefect defect = PixelDefect::None;
    glm::vec3 normal{0.0f}; ///< is in world space, on the viewer's side
    float nv = 0.0f;
    std::optional<glm::vec3> albedo; ///< is the share of a uniform white sky that is reflected to
                                     ///< the viewer
    std::vector<LightShare> lights;
    std::optional<glm::vec3> ambient;
    std::optional<glm::vec3> emission;
    std::optional<BlendedColor> blended; ///< was blended by the Fresnel term's reflectance
    std::optional<BlendedColor> fogged;  ///< was blended by the share of the surface that is left
    glm::vec3 color{0.0f};               ///< is the final colour
    float opacity = 1.0f;
};

} // namespace patina
