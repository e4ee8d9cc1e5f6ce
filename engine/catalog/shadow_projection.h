// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace patina {

/// Tells how the rays of a light run, which is how its depth map looks at the scene.
enum class ShadowProjection {
    None,     ///< it casts no shadows
    Parallel, ///< along its direction, from very far away
    Cone,     ///< from its position about its direction, as far as its widest angle
    Sphere    ///< from its position everywhere
};

} // namespace patina
