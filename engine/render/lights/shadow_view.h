// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "catalog/block.h"
#include "core/mesh.h"

namespace patina {

/// Says how the depth map of one light looks at the scene: a right-handed frame whose `forward` is
/// the way the light travels, and the window of the map in it. The first value is a map of nothing.
struct ShadowView {
    glm::dvec3 right{1.0, 0.0, 0.0};
    glm::dvec3 up{0.0, 1.0, 0.0};
    glm::dvec3 forward{0.0, 0.0, 1.0};
    glm::dvec3 origin{0.0};
    /// Scale and shift into 0 .. 1, of metres (parallel light) or slopes; the default is nowhere.
    glm::dvec4 window{0.0, 0.0, -2.0, -2.0};
    double near = 1.0; ///< metres along `forward`, > 0 for a light with a place
    double far = 2.0;
    double texel = 0.0; ///< metres, for a light with a place one metre in front of it
    double size = 0.0;  ///< metres: the longest side of the box around all that casts
    bool isParallel = false;
    int faces = 0; ///< layers of the map; 0: there is none
    int layer = 0; ///< the first of them

    friend bool operator==(const ShadowView&, const ShadowView&) = default;
};

/// Returns one of the eight corners of a box, as a point.
glm::dvec4 cornerOf(const Bounds& box, int corner);

/// Holds what casts shadows: a box of its own space and its way into the world.
struct CasterBox {
    Bounds bounds;
    glm::dmat4 world{1.0};

    friend bool operator==(const CasterBox&, const CasterBox&) = default;
};

/// Returns the view of a light of kind `light` with these values: as narrow as the casters allow,
/// in steps so that what moves does not make edges swim. Which parameter holds the position, the
/// direction and the angle follows from their `space` and type. `texels` is the map's size.
ShadowView shadowViewOf(const Block& light, const Values& values, const glm::dmat4& cameraToWorld,
                        std::span<const CasterBox> casters, int texels);

/// Leads from world space to the clip space of one face of the map.
glm::dmat4 shadowClip(const ShadowView& view, int face);

/// Fills the vec4s of ShadowLayout.
void packView(std::span<glm::vec4> out, const ShadowView& view);

} // namespace patina
