// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/gpu_mesh.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include <epoxy/gl.h>

namespace patina {

GpuMesh::GpuMesh(const MeshView& mesh, std::uint64_t serial)
    : triangles_(static_cast<int>(mesh.indices.size() / 3)), serial_(serial) {
    // A target that no vertex array remembers.
    vertices_.reserve(GL_COPY_WRITE_BUFFER, mesh.vertices.size_bytes(),
                      gl::Buffer::Content::Lasting);
    indices_.reserve(GL_COPY_WRITE_BUFFER, mesh.indices.size_bytes(),
                     gl::Buffer::Content::Lasting);
}

gl::VertexArray GpuMesh::makeArray() const {
    gl::VertexArray array = gl::VertexArray::create();
    array.bind();
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.name());
    array.attribute(0, vertices_, 3, sizeof(Vertex), offsetof(Vertex, position));
    array.attribute(1, vertices_, 3, sizeof(Vertex), offsetof(Vertex, normal));
    array.attribute(2, vertices_, 3, sizeof(Vertex), offsetof(Vertex, tangent));
    array.attribute(3, vertices_, 2, sizeof(Vertex), offsetof(Vertex, uv));
    array.attribute(4, vertices_, 1, sizeof(Vertex),
                    offsetof(Vertex, tangent) + offsetof(glm::vec4, w));
    return array;
}

void GpuMesh::upload(const MeshView& mesh, std::size_t bytes) {
    const std::size_t split = vertices_.size();
    const bool isVertices = uploaded_ < split;
    const auto content = isVertices ? std::as_bytes(mesh.vertices) : std::as_bytes(mesh.indices);
    const std::size_t offset = isVertices ? uploaded_ : uploaded_ - split;
    const auto slice = content.subspan(offset, std::min(bytes, content.size() - offset));
    (isVertices ? vertices_ : indices_).write(GL_COPY_WRITE_BUFFER, slice, offset);
    uploaded_ += slice.size();
}

GpuMesh::Array& GpuMesh::arrayFor(const InstanceBuffer& instances) const {
    const auto known = std::ranges::find(arrays_, instances.buffer(), &Array::instances);
    if (known != arrays_.end()) {
        return *known;
    }
    // Buffers that nobody fills any more.
    std::erase_if(arrays_, [](const Array& array) { return array.instances.use_count() == 1; });
    arrays_.push_back({instances.buffer(), 0, makeArray()});
    Array& made = arrays_.back();
    made.array.instanced(Instance::firstAttribute, *made.instances, Instance::attributes, 0);
    return made;
}

/// Without base instances it is the attributes that begin at the first instance.
void GpuMesh::draw(const InstanceBuffer& instances, const DrawRange& range) const {
    Array& held = arrayFor(instances);
    held.array.bind();
    const std::size_t start = instances.hasBase() ? 0 : range.firstInstance * sizeof(Instance);
    if (start != held.offset) {
        held.array.instanced(Instance::firstAttribute, *held.instances, Instance::attributes,
                             start);
        held.offset = start;
    }
    const int count = 3 * range.triangles;
    const auto* first = reinterpret_cast<const void*>( // NOLINT: GL passes offsets so
        3 * sizeof(std::uint32_t) * static_cast<std::size_t>(range.firstTriangle));
    const auto objects = static_cast<GLsizei>(range.instances);
    if (instances.hasBase()) {
        glDrawElementsInstancedBaseInstance(GL_TRIANGLES, count, GL_UNSIGNED_INT, first, objects,
                                            static_cast<GLuint>(range.firstInstance));
    } else {
        glDrawElementsInstanced(GL_TRIANGLES, count, GL_UNSIGNED_INT, first, objects);
    }
}

} // namespace patina
