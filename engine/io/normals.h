// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/raw_mesh.h"

namespace patina {

/// Makes every normal unit. Missing ones become the angle-weighted mean of the faces around the
/// place (Thuermer and Wuethrich 1998), smooth over every edge; where that mean vanishes (two faces
/// back to back) they become the normal of one of the faces.
void completeNormals(RawMesh& mesh);

} // namespace patina
