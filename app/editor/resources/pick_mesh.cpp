// SPDX-License-Identifier: GPL-3.0-or-later
#include "resources/pick_mesh.h"

#include <algorithm>
#include <cstdint>

namespace patina {

std::vector<Bounds> runBoundsOf(const MeshView& mesh) {
    constexpr std::size_t perRun = 3 * trianglesPerRun;
    const std::span<const std::uint32_t> indices = mesh.indices;
    std::vector<Bounds> runs;
    runs.reserve(indices.size() / perRun + 1);
    for (std::size_t first = 0; first < indices.size(); first += perRun) {
        Bounds& run = runs.emplace_back();
        for (const std::uint32_t index :
             indices.subspan(first, std::min(perRun, indices.size() - first))) {
            run.add(mesh.vertices[index].position);
        }
    }
    return runs;
}

} // namespace patina
