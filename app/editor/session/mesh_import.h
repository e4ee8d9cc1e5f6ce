// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace patina {

/// Says how a mesh file becomes an object.
struct MeshImport {
    bool fits = true;   ///< says that it is fitted into a unit box, before the scale
    double scale = 1.0; ///< metres of one unit of the file
    bool flips = false; ///< says that normals which point inwards are turned
    bool isZUp = false; ///< z is up in the file, not y
    /// Says that it is one object, whatever its materials.
    bool joins = false;

    friend bool operator==(const MeshImport&, const MeshImport&) = default;
};

} // namespace patina
