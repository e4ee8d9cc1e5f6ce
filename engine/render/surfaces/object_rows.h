// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "render/gpu/texture_source.h"
#include "render/view.h"
#include "shading/effects/effect_rows.h"

namespace patina {

/// Holds what is known of a scene's images.
struct KnownImages {
    TextureSource textures{};          ///< empty: nothing is known of those on surfaces
    bool isEnvironmentMissing = false; ///< a placeholder is in its place
};

/// Returns the effects of one object of the scene as the scene's camera sees them, by what is known
/// of its mesh and of images too: lights that do not reach it are out, with the distance, and
/// images say that their file is missing or the mesh has no texture coordinates. What only a mesh
/// tells is not told while it is not there. `aspect` is the picture's width over its height, so
/// that an object outside of it says so; 0: nobody knows.
std::vector<EffectRow> objectRows(const Scene& scene, std::size_t object, const Catalog& catalog,
                                  const MeshSource& meshes, const KnownImages& images = {},
                                  double aspect = 0.0);

/// Why an object is not drawn, as its rows say; empty where it is. `aspect` as above.
std::string whyNotDrawn(const Scene& scene, std::size_t object, const MeshSource& meshes,
                        double aspect);

} // namespace patina
