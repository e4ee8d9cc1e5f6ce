// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <glm/vec3.hpp>

namespace patina {

/// Tells what the numerical check finds in a pixel; the last of several is shown. The numbers are
/// those of shaders/passes/inspection.glsl.
enum class PixelDefect { None, AboveOne, Negative, Infinite, NotANumber };

/// Holds what one light sends to the viewer from a point.
struct LightShare {
    std::size_t light = 0; ///< its place in the scene
    glm::vec3 value{0.0f}; ///< its light times the model's value, before that is cut at 0
    float nl = 0.0f;       ///< cosine of its direction with the normal
};

/// Represents a colour after blending, and the share that blended.
struct BlendedColor {
    glm::vec3 value{0.0f};
    float share = 0.0f;
};

/// Holds the numbers of one pixel as they were computed: linear, before exposure. What is not in
/// the program is not here.
struct PixelProbe {
    std::size_t object = 0; ///< its place in the scene
    PixelDefect defect = PixelDefect::None;
    glm::vec3 normal{0.0f}; ///< in world space, on the viewer's side
    float nv = 0.0f;
    std::optional<glm::vec3> albedo; ///< share of a uniform white sky that comes to the viewer
    std::vector<LightShare> lights;
    std::optional<glm::vec3> ambient;
    std::optional<glm::vec3> emission;
    std::optional<BlendedColor> blended; ///< by the Fresnel term's reflectance
    std::optional<BlendedColor> fogged;  ///< by the share of the surface that is left
    glm::vec3 color{0.0f};               ///< all of it
    float opacity = 1.0f;
};

} // namespace patina
