// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/gpu_mesh.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include <epoxy/gl.h>

namespace patina {

GpuMesh::GpuMesh(const MeshView& mesh, std::uint64_t serial)
    : triangles_(static_cast<int>(mesh.indices.size() / 3)), serial_(serial) {
    array_.bind();
    vertices_.reserve(GL_ARRAY_BUFFER, mesh.vertices.size_bytes(), gl::Buffer::Content::Lasting);
    indices_.reserve(GL_ELEMENT_ARRAY_BUFFER, mesh.indices.size_bytes(),
                     gl::Buffer::Content::Lasting);
    array_.attribute(0, vertices_, 3, sizeof(Vertex), offsetof(Vertex, position));
    array_.attribute(1, vertices_, 3, sizeof(Vertex), offsetof(Vertex, normal));
    array_.attribute(2, vertices_, 3, sizeof(Vertex), offsetof(Vertex, tangent));
    array_.attribute(3, vertices_, 2, sizeof(Vertex), offsetof(Vertex, uv));
    array_.attribute(4, vertices_, 1, sizeof(Vertex),
                     offsetof(Vertex, tangent) + offsetof(glm::vec4, w));
    glBindVertexArray(0);
}

void GpuMesh::upload(const MeshView& mesh, std::size_t bytes) {
    const std::size_t split = vertices_.size();
    const bool isVertices = uploaded_ < split;
    const auto content = isVertices ? std::as_bytes(mesh.vertices) : std::as_bytes(mesh.indices);
    const std::size_t offset = isVertices ? uploaded_ : uploaded_ - split;
    const auto slice = content.subspan(offset, std::min(bytes, content.size() - offset));
    // A target that no vertex array remembers.
    (isVertices ? vertices_ : indices_).write(GL_COPY_WRITE_BUFFER, slice, offset);
    uploaded_ += slice.size();
}

void GpuMesh::draw(int first, int count) const {
    array_.bind();
    const std::size_t offset = 3 * sizeof(std::uint32_t) * static_cast<std::size_t>(first);
    glDrawElements(GL_TRIANGLES, 3 * count, GL_UNSIGNED_INT,
                   reinterpret_cast<const void*>(offset)); // NOLINT: GL passes offsets so
}

} // namespace patina
