// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace patina {

/// Says what is done to a mesh while it is read.
struct MeshOptions {
    double scale = 1.0;
    /// The mesh is centred and its longest side becomes 2 before it is scaled.
    bool fitUnitBox = false;
    bool flipNormals = false;
    /// The triangles of each material become a part of their own.
    bool byMaterial = false;

    friend bool operator==(const MeshOptions&, const MeshOptions&) = default;
};

} // namespace patina
