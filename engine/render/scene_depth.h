// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "render/renderer.h"
#include "shading/effect_view.h"

namespace patina {

/// What a camera's view says to the choice of effects: what the renderer takes for its programs.
EffectView effectView(const Scene& scene, const Camera& camera, const MeshSource& meshes);

} // namespace patina
