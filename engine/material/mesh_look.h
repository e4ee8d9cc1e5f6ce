// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh_material.h"
#include "material/material.h"

namespace patina {

/// Returns the preset that looks as a mesh file says of a material, by the recipes in
/// presets/mesh-looks.json, with its images. Fails where there is no recipe for its look, and where
/// the recipes cannot be read or do not fit the catalogue.
Result<Material> materialOf(const MeshMaterial& from, const Catalog& catalog);

} // namespace patina
