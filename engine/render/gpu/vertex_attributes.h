// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "core/mesh.h"
#include "gl/buffer.h"
#include "gl/vertex_array.h"

namespace patina {

/// Has a vertex array read a mesh's vertices as passes/surface.vert does: 0 position, 1 normal, 2
/// tangent, 3 texture coordinates, 4 the sign of the bitangent. Leaves the vertex array bound.
inline void vertexAttributes(gl::VertexArray& array, const gl::Buffer& vertices) {
    array.attribute(0, vertices, 3, sizeof(Vertex), offsetof(Vertex, position));
    array.attribute(1, vertices, 3, sizeof(Vertex), offsetof(Vertex, normal));
    array.attribute(2, vertices, 3, sizeof(Vertex), offsetof(Vertex, tangent));
    array.attribute(3, vertices, 2, sizeof(Vertex), offsetof(Vertex, uv));
    array.attribute(4, vertices, 1, sizeof(Vertex),
                    offsetof(Vertex, tangent) + offsetof(glm::vec4, w));
}

/// Follows the curvature of a vertex, as in passes/vertex_color.vert.
inline constexpr unsigned colorAttribute = 14;

} // namespace patina
