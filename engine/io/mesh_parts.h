// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "io/raw_mesh.h"

namespace patina {

/// Takes a mesh apart by materials, in the order in which its triangles first use them. Each part
/// has its material as the only one, and those without one make a part without. Where there are
/// more than 256 the last part has all the others.
std::vector<RawMesh> splitByMaterial(RawMesh mesh);

/// Returns a material for a part without one. Its name is unlike those of the others.
MeshMaterial nameless(const std::vector<MeshMaterial>& others);

/// Gives every material a name that no other one has: what has none is called "Material", and what
/// repeats one has a number behind it.
void nameUniquely(std::vector<MeshMaterial>& materials);

} // namespace patina
