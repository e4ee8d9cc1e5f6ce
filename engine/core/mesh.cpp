// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh.h"

#include <glm/common.hpp>

namespace patina {

void Bounds::add(const glm::vec3& point) {
    lower = glm::min(lower, point);
    upper = glm::max(upper, point);
}

Bounds boundsOf(std::span<const Vertex> vertices) {
    Bounds bounds;
    for (const Vertex& vertex : vertices) {
        bounds.add(vertex.position);
    }
    return bounds;
}

} // namespace patina
