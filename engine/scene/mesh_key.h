// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "scene/scene.h"

namespace patina {

/// Identifies the triangles of an object: two objects with equal keys have the same ones.
struct MeshKey {
    std::string mesh;
    std::string part;
    bool fitUnitBox = false;
    bool flipNormals = false;

    friend auto operator<=>(const MeshKey&, const MeshKey&) = default;
};

inline MeshKey meshKey(const Object& object) {
    return {object.mesh, object.part, object.fitUnitBox, object.flipNormals};
}

} // namespace patina
