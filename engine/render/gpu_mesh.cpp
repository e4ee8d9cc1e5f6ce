// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/gpu_mesh.h"

#include <cstddef>

#include <epoxy/gl.h>

namespace patina {

GpuMesh::GpuMesh(const MeshView& mesh) : count_(static_cast<int>(mesh.indices.size())) {
    array_.bind();
    vertices_.fill(GL_ARRAY_BUFFER, std::as_bytes(mesh.vertices));
    indices_.fill(GL_ELEMENT_ARRAY_BUFFER, std::as_bytes(mesh.indices));
    array_.attribute(0, vertices_, 3, sizeof(Vertex), offsetof(Vertex, position));
    array_.attribute(1, vertices_, 3, sizeof(Vertex), offsetof(Vertex, normal));
    array_.attribute(2, vertices_, 3, sizeof(Vertex), offsetof(Vertex, tangent));
    glBindVertexArray(0);
}

void GpuMesh::draw() const {
    array_.bind();
    glDrawElements(GL_TRIANGLES, count_, GL_UNSIGNED_INT, nullptr);
}

} // namespace patina
