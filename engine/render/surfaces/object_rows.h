// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "render/gpu/texture_source.h"
#include "render/view.h"
#include "shading/effects/effect_rows.h"

namespace patina {

/// Says which of a scene's images are missing, as far as that is known.
struct KnownImages {
    TextureSource textures{};          ///< is empty when nothing is known of images on surfaces
    bool isEnvironmentMissing = false; ///< says that a placeholder replaces the environment's
                                       ///< picture
};

/// Returns the rows of effects of one object, seen from the scene's camera. They use its mesh and
/// images: a light that does not reach it is out, with the distance as the reason, and an image's
/// row says when its file is missing or the mesh has no texture coordinates. While the mesh is
/// missing, reasons that need it are left out. `aspect` is the picture's width over its height, by
/// which an object outside the picture is found; 0 when that is unknown.
std::vector<EffectRow> objectRows(const Scene& scene, std::size_t object, const Catalog& catalog,
                                  const MeshSource& meshes, const KnownImages& images = {},
                                  double aspect = 0.0);

/// Returns why an object is not drawn, as a sentence for its rows; empty where it is drawn.
/// `aspect` is the same as above.
std::string whyNotDrawn(const Scene& scene, std::size_t object, const Catalog& catalog,
                        const MeshSource& meshes, double aspect);

} // namespace patina
