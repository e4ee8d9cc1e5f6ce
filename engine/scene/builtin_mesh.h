// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/error.h"
#include "core/mesh.h"
#include "scene/scene.h"

namespace patina {

/// Returns the mesh made by code that `object.mesh` names ("builtin:sphere"), fitted into [-1, 1]^3
/// and turned inside out where the object asks for that, as meshes of files are. It is an error
/// where no such mesh has this name.
Result<Mesh> builtinMesh(const Object& object);

} // namespace patina
