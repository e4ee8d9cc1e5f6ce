// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/gpu/gpu_mesh.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <epoxy/gl.h>

#include "render/gpu/valid_normals.h"
#include "render/gpu/vertex_attributes.h"

namespace patina {
namespace {

/// Follows the attributes of Instance, as in passes/openness.vert.
constexpr unsigned opennessAttribute = Instance::firstAttribute + Instance::attributes;

/// Writes the bytes from `offset` on, at most `bytes` of them, and returns how many.
std::size_t writeSlice(gl::Buffer& target, std::span<const std::byte> content, std::size_t offset,
                       std::size_t bytes) {
    const auto slice = content.subspan(offset, std::min(bytes, content.size() - offset));
    target.write(GL_COPY_WRITE_BUFFER, slice, offset);
    return slice.size();
}

/// Does the same for vertices, and makes their normals valid on the way.
std::size_t writeVertices(gl::Buffer& target, std::span<const Vertex> vertices, std::size_t offset,
                          std::size_t bytes) {
    const std::size_t end = offset + std::min(bytes, vertices.size_bytes() - offset);
    const std::size_t first = offset / sizeof(Vertex);
    const auto touched =
        vertices.subspan(first, (end + sizeof(Vertex) - 1) / sizeof(Vertex) - first);
    if (haveValidNormals(touched)) {
        return writeSlice(target, std::as_bytes(vertices), offset, bytes);
    }
    const std::vector<Vertex> valid = withValidNormals(touched);
    const auto slice =
        std::as_bytes(std::span(valid)).subspan(offset - first * sizeof(Vertex), end - offset);
    target.write(GL_COPY_WRITE_BUFFER, slice, offset);
    return slice.size();
}

} // namespace

GpuMesh::GpuMesh(const MeshView& mesh, std::uint64_t serial)
    : triangles_(static_cast<int>(mesh.indices.size() / 3)), serial_(serial) {
    // A vertex array does not record this target.
    vertices_.reserve(GL_COPY_WRITE_BUFFER, mesh.vertices.size_bytes(),
                      gl::Buffer::Content::Lasting);
    indices_.reserve(GL_COPY_WRITE_BUFFER, mesh.indices.size_bytes(), gl::Buffer::Content::Lasting);
}

gl::VertexArray GpuMesh::makeArray() const {
    gl::VertexArray array = gl::VertexArray::create();
    array.bind();
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.name());
    vertexAttributes(array, vertices_);
    if (openness_) {
        array.shorts(opennessAttribute, *openness_);
    }
    if (colors_) {
        array.shares(colorAttribute, *colors_);
    }
    if (curvature_ && curvature_->isComplete()) {
        curvature_->readBy(array);
    }
    return array;
}

void GpuMesh::upload(const MeshView& mesh, std::size_t bytes) {
    const std::size_t split = vertices_.size();
    uploaded_ += uploaded_ < split
                     ? writeVertices(vertices_, mesh.vertices, uploaded_, bytes)
                     : writeSlice(indices_, std::as_bytes(mesh.indices), uploaded_ - split, bytes);
}

/// Drops the vertex arrays too, since new ones have one attribute more.
void GpuMesh::takeOpenness(const MeshView& mesh) {
    if (openness_ || mesh.openness.empty() || mesh.openness.size() != mesh.vertices.size()) {
        return;
    }
    openness_ = gl::Buffer::create();
    openness_->reserve(GL_COPY_WRITE_BUFFER, mesh.openness.size_bytes(),
                       gl::Buffer::Content::Lasting);
    openness_->write(GL_COPY_WRITE_BUFFER, std::as_bytes(mesh.openness), 0);
    arrays_ = InstancedArrays();
}

/// Drops the vertex arrays too, and the edges with theirs.
void GpuMesh::takeColors(const MeshView& mesh) {
    if (colors_ || mesh.colors.empty() || mesh.colors.size() != mesh.vertices.size()) {
        return;
    }
    colors_ = gl::Buffer::create();
    colors_->reserve(GL_COPY_WRITE_BUFFER, mesh.colors.size_bytes(), gl::Buffer::Content::Lasting);
    colors_->write(GL_COPY_WRITE_BUFFER, std::as_bytes(mesh.colors), 0);
    arrays_ = InstancedArrays();
    edges_.reset();
}

bool GpuMesh::takeCurvature(const MeshView& mesh) {
    if (!curvature_) {
        curvature_.emplace(mesh);
    }
    if (curvature_->isComplete()) {
        return true;
    }
    curvature_->proceed(mesh);
    if (curvature_->isComplete()) {
        arrays_ = InstancedArrays(); // new ones have two attributes more
    }
    return curvature_->isComplete();
}

void GpuMesh::draw(const InstanceBuffer& instances, const DrawRange& range) const {
    arrays_.draw(GL_TRIANGLES, 3, instances, range, [this] { return makeArray(); });
}

GpuEdges& GpuMesh::edges(const MeshView& mesh, std::uint64_t frame) {
    edgesFrame_ = frame;
    return edges_ ? *edges_ : edges_.emplace(mesh);
}

GpuMarks& GpuMesh::marks(const MeshView& mesh, std::uint64_t frame) {
    marksFrame_ = frame;
    return marks_ ? *marks_ : marks_.emplace(mesh);
}

const ConvexFacets& GpuMesh::facets(const MeshView& mesh) {
    return facets_ ? *facets_ : facets_.emplace(convexFacetsOf(mesh));
}

void GpuMesh::forgetUnused(std::uint64_t frame) {
    if (edgesFrame_ < frame) {
        edges_.reset();
    }
    if (marksFrame_ < frame) {
        marks_.reset();
    }
}

} // namespace patina
