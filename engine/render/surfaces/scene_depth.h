// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "render/view.h"
#include "shading/effects/effect_view.h"

namespace patina {

/// Returns what a camera's view says to the choice of effects: what the renderer takes for its
/// programs, but for the lights, which are another matter for each object.
EffectView effectView(const Scene& scene, const Camera& camera, const Catalog& catalog,
                      const MeshSource& meshes);

/// Returns what the renderer takes for the program of one object, seen by the scene's camera.
EffectView objectView(const Scene& scene, std::size_t object, const Catalog& catalog,
                      const MeshSource& meshes);

} // namespace patina
