// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace patina {

/// Tells how the rays of a light run, which is how its shadow map projects the scene.
enum class ShadowProjection {
    None,     ///< the light casts no shadows
    Parallel, ///< rays run along the light's direction, from very far away
    Cone,     ///< rays run from its position about its direction, up to its widest angle
    Sphere    ///< rays run from its position in all directions
};

} // namespace patina
