// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "render/renderer.h"

namespace patina {

class MeshLibrary;

/// The meshes of a scene for other threads: those that are there now. They lie still in the library
/// until it goes.
MeshSource meshSnapshot(const Scene& scene, MeshLibrary& library);

} // namespace patina
