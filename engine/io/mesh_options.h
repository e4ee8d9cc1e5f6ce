// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace patina {

/// Holds what to do to a mesh while it is read.
struct MeshOptions {
    double scale = 1.0;
    bool fitUnitBox = false; ///< centred, and scaled so that the longest side is 2; then `scale`
    bool flipNormals = false;

    friend bool operator==(const MeshOptions&, const MeshOptions&) = default;
};

} // namespace patina
