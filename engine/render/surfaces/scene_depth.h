// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "render/view.h"
#include "shading/effects/effect_view.h"

namespace patina {

/// Returns what the choice of effects depends on in a camera's view, as the renderer computes it.
/// EffectView::unreached is left empty, since lights differ for each object.
EffectView effectView(const Scene& scene, const Camera& camera, const Catalog& catalog,
                      const MeshSource& meshes);

/// Returns the same for one object, with the lights that do not reach it, seen by the scene's
/// camera.
EffectView objectView(const Scene& scene, std::size_t object, const Catalog& catalog,
                      const MeshSource& meshes);

} // namespace patina
