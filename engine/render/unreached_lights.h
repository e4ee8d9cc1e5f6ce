// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "render/renderer.h"
#include "shading/effect_rows.h"

namespace patina {

/// A row for each light that shines and does not reach an object of the scene, with the distance:
/// the object is not shaded for it. None while its mesh is not there.
std::vector<EffectRow> unreachedRows(const Scene& scene, std::size_t object,
                                     const Catalog& catalog, const MeshSource& meshes);

} // namespace patina
