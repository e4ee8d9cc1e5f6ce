// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/gpu/gpu_edges.h"

#include <algorithm>
#include <cstddef>
#include <span>

#include <epoxy/gl.h>

#include "render/gpu/edge_finder.h"
#include "render/gpu/vertex_attributes.h"

namespace patina {
namespace {

/// Each of these amounts takes some milliseconds.
constexpr std::size_t itemsAtOnce = 32768;
constexpr std::size_t bytesAtOnce = std::size_t(4) << 20;

} // namespace

GpuEdges::GpuEdges(const MeshView& mesh) : finder_(std::make_unique<EdgeFinder>(mesh)) {}

GpuEdges::~GpuEdges() = default;
GpuEdges::GpuEdges(GpuEdges&&) noexcept = default;
GpuEdges& GpuEdges::operator=(GpuEdges&&) noexcept = default;

void GpuEdges::proceed(const MeshView& mesh) {
    static_assert(sizeof(MeshEdge) == bytesPerEdge);
    if (!finder_->isDone()) {
        finder_->proceed(mesh, itemsAtOnce);
        return;
    }
    const auto bytes = std::as_bytes(finder_->edges());
    if (uploaded_ == 0) {
        // A vertex array does not record this target.
        indices_.reserve(GL_COPY_WRITE_BUFFER, bytes.size(), gl::Buffer::Content::Lasting);
    }
    const auto slice = bytes.subspan(uploaded_, std::min(bytesAtOnce, bytes.size() - uploaded_));
    if (!slice.empty()) {
        indices_.write(GL_COPY_WRITE_BUFFER, slice, uploaded_);
    }
    uploaded_ += slice.size();
    if (uploaded_ == bytes.size()) {
        finder_.reset();
    }
}

gl::VertexArray GpuEdges::makeArray(const gl::Buffer& vertices, const gl::Buffer* colors) const {
    gl::VertexArray array = gl::VertexArray::create();
    array.bind();
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.name());
    vertexAttributes(array, vertices);
    if (colors != nullptr) {
        array.shares(colorAttribute, *colors);
    }
    return array;
}

void GpuEdges::draw(const gl::Buffer& vertices, const gl::Buffer* colors,
                    const InstanceBuffer& instances, const DrawRange& range) const {
    arrays_.draw(GL_LINES_ADJACENCY, 4, instances, range,
                 [this, &vertices, colors] { return makeArray(vertices, colors); });
}

} // namespace patina
