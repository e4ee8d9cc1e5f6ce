// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/mesh.h"

namespace patina {

/// Returns true when each normal is zero or has a length from 1/2 to 2, as any rounded unit normal
/// has. Shaders normalize such normals without further checks.
bool haveValidNormals(std::span<const Vertex> vertices);

/// Returns the vertices with valid normals. Another normal is normalized if it has a direction, and
/// becomes zero if a component is infinite or not a number. A surface with a zero normal is shaded
/// as if it faced the viewer.
std::vector<Vertex> withValidNormals(std::span<const Vertex> vertices);

} // namespace patina
