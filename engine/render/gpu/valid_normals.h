// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/mesh.h"

namespace patina {

/// Tells whether each normal is zero or has a length from 1/2 to 2, which no rounding of a unit
/// normal leaves. Shaders scale normals and make them unit, and look for nothing else.
bool haveValidNormals(std::span<const Vertex> vertices);

/// Returns the same vertices with such normals. Of others those that have a direction keep it and
/// become unit; those that have none (a component is infinite or not a number) become zero. A
/// surface without a normal is shaded as if it faced the viewer.
std::vector<Vertex> withValidNormals(std::span<const Vertex> vertices);

} // namespace patina
