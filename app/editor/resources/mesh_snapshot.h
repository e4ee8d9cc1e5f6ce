// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "render/renderer.h"

namespace patina {

class MeshLibrary;

/// Returns the meshes of a scene that are loaded now, for another thread. They point into the
/// library, which has to outlive their use.
MeshSource meshSnapshot(const Scene& scene, MeshLibrary& library);

} // namespace patina
