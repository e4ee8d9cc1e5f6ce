// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/triangle_filter.h"

#include <cmath>

#include <glm/geometric.hpp>

namespace patina {
namespace {

/// Beyond this, squares of lengths come near the end of the float range on the GPU (1e38).
constexpr float farthest = 1e15f;

/// Also false for NaN.
bool isUsable(const glm::vec3& p) {
    return std::abs(p.x) < farthest && std::abs(p.y) < farthest && std::abs(p.z) < farthest;
}

/// In doubles: the area of a triangle 1e-15 wide is no float, and must not count as zero.
bool hasArea(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    const glm::dvec3 normal =
        glm::cross(glm::dvec3(b) - glm::dvec3(a), glm::dvec3(c) - glm::dvec3(a));
    return normal.x != 0.0 || normal.y != 0.0 || normal.z != 0.0;
}

} // namespace

std::size_t dropUselessTriangles(RawMesh& mesh) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const std::uint32_t corners[] = {mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]};
        const glm::vec3& a = mesh.positions[corners[0]];
        const glm::vec3& b = mesh.positions[corners[1]];
        const glm::vec3& c = mesh.positions[corners[2]];
        if (isUsable(a) && isUsable(b) && isUsable(c) && hasArea(a, b, c)) {
            mesh.indices[kept] = corners[0];
            mesh.indices[kept + 1] = corners[1];
            mesh.indices[kept + 2] = corners[2];
            kept += 3;
        }
    }
    const std::size_t dropped = (mesh.indices.size() - kept) / 3;
    mesh.indices.resize(kept);
    return dropped;
}

} // namespace patina
