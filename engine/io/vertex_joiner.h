// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "io/raw_mesh.h"

namespace patina {

/// Joins vertices that agree in every attribute, and drops those that no triangle uses.
void joinVertices(RawMesh& mesh);

/// Numbers the places of the vertices: vertices at the same position share one. Places are
/// numbered from zero without gaps.
struct Places {
    std::vector<std::uint32_t> ofVertex; ///< is empty when every vertex has a place of its own
    std::size_t count = 0;
};
Places placesOf(const RawMesh& mesh);

} // namespace patina
