// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/raw_mesh.h"

namespace patina {

/// Completes the tangents; needs unit normals. Where texture coordinates determine it, a tangent is
/// the direction of growing u, and w tells the side of growing v; vertices on a mirror seam are
/// doubled. Elsewhere it runs around the y axis (around the x axis on surfaces that face along y),
/// as the marks of a lathe would. All are unit and orthogonal to the normal.
void completeTangents(RawMesh& mesh);

} // namespace patina
