// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "catalog/block.h"
#include "core/mesh.h"

namespace patina {

/// Says how the shadow map of one light sees the scene: a right-handed frame whose `forward` is the
/// direction in which the light travels, and the window of the map in it. The default is a map of
/// nothing.
struct ShadowView {
    glm::dvec3 right{1.0, 0.0, 0.0};
    glm::dvec3 up{0.0, 1.0, 0.0};
    glm::dvec3 forward{0.0, 0.0, 1.0};
    glm::dvec3 origin{0.0};
    /// Holds the scale (x, y) and shift (z, w) that bring metres (for parallel light) or slopes
    /// into 0 .. 1. With the default no point is in the map.
    glm::dvec4 window{0.0, 0.0, -2.0, -2.0};
    double near = 1.0; ///< metres along `forward`, > 0 for a light with a position
    double far = 2.0;
    double texel = 0.0; ///< metres; for a light with a position, at one metre in front of it
    double size = 0.0;  ///< metres: the longest side of the box around all casters
    bool isParallel = false;
    int faces = 0; ///< is the number of layers of the map; 0 when there is no map
    int layer = 0; ///< is the first layer

    friend bool operator==(const ShadowView&, const ShadowView&) = default;
};

/// Returns one of the eight corners of a box as a point (w = 1); bits 0 to 2 of `corner` choose the
/// upper x, y and z.
glm::dvec4 cornerOf(const Bounds& box, int corner);

/// Holds a caster of shadows: a box of its own space and the transform into the world.
struct CasterBox {
    Bounds bounds;
    glm::dmat4 world{1.0};

    friend bool operator==(const CasterBox&, const CasterBox&) = default;
};

/// Returns the view of a light of kind `light` with these values. It is as narrow as the casters
/// allow, and its size and place change in steps, so that edges do not swim while things move. The
/// position, direction and angle are the parameters with such a `space` or type. `texels` is the
/// side of the map.
ShadowView shadowViewOf(const Block& light, const Values& values, const glm::dmat4& cameraToWorld,
                        std::span<const CasterBox> casters, int texels);

/// Returns the transform from world space to the clip space of one face of the map, 0 to
/// ShadowView::faces - 1.
glm::dmat4 shadowClip(const ShadowView& view, int face);

/// Writes the vec4s of ShadowLayout to `out`.
void packView(std::span<glm::vec4> out, const ShadowView& view);

} // namespace patina
