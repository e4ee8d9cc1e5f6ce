// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/triangle_filter.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/vectors.h"

namespace patina {
namespace {

/// Limits coordinates: beyond this, squares of lengths come near the end of the float range on the
/// GPU (1e38).
constexpr float farthest = 1e15f;

bool isNear(const glm::vec3& p) {
    return std::abs(p.x) < farthest && std::abs(p.y) < farthest && std::abs(p.z) < farthest;
}

/// Computes in doubles: the area of a triangle 1e-15 wide underflows in floats, and must not count
/// as zero.
bool hasArea(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    const glm::dvec3 normal =
        glm::cross(glm::dvec3(b) - glm::dvec3(a), glm::dvec3(c) - glm::dvec3(a));
    return normal.x != 0.0 || normal.y != 0.0 || normal.z != 0.0;
}

/// Tells whether a triangle can be drawn, and counts it where it cannot.
bool isUseful(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c,
              UselessTriangles& useless) {
    if (!isFinite(a) || !isFinite(b) || !isFinite(c)) {
        ++useless.notFinite;
    } else if (!isNear(a) || !isNear(b) || !isNear(c)) {
        ++useless.tooFar;
    } else if (!hasArea(a, b, c)) {
        ++useless.noArea;
    } else {
        return true;
    }
    return false;
}

} // namespace

std::string UselessTriangles::reasons() const {
    std::string text;
    const auto add = [&text](std::size_t count, const char* reason) {
        text += count == 0 ? "" : text.empty() ? reason : std::string(" or ") + reason;
    };
    add(noArea, "no area");
    add(notFinite, "no finite position");
    add(tooFar, "positions too large to draw (beyond 1e15)");
    return text;
}

UselessTriangles dropUselessTriangles(RawMesh& mesh) {
    UselessTriangles useless;
    std::size_t kept = 0;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const std::uint32_t corners[] = {mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]};
        if (isUseful(mesh.positions[corners[0]], mesh.positions[corners[1]],
                     mesh.positions[corners[2]], useless)) {
            mesh.indices[kept] = corners[0];
            mesh.indices[kept + 1] = corners[1];
            mesh.indices[kept + 2] = corners[2];
            if (i / 3 < mesh.materialOf.size()) {
                mesh.materialOf[kept / 3] = mesh.materialOf[i / 3];
            }
            kept += 3;
        }
    }
    mesh.indices.resize(kept);
    mesh.materialOf.resize(std::min(mesh.materialOf.size(), kept / 3));
    return useless;
}

} // namespace patina
