// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/gpu/gpu_curvature.h"

#include <cstddef>
#include <span>

#include <epoxy/gl.h>

namespace patina {
namespace {

/// Takes some milliseconds.
constexpr std::size_t curvaturesAtOnce = 16384;

/// Follow the openness of a vertex, as in passes/drawn_curvature.vert.
constexpr unsigned diagonalAttribute = 12;
constexpr unsigned mixedAttribute = 13;

} // namespace

GpuCurvature::GpuCurvature(const MeshView& mesh)
    : finder_(std::make_unique<CurvatureFinder>(mesh)) {}

void GpuCurvature::proceed(const MeshView& mesh) {
    if (!finder_->isDone()) {
        finder_->proceed(mesh, curvaturesAtOnce);
        return;
    }
    const auto bytes = std::as_bytes(std::span(finder_->curvatures()));
    // A vertex array does not record this target.
    buffer_.reserve(GL_COPY_WRITE_BUFFER, bytes.size(), gl::Buffer::Content::Lasting);
    buffer_.write(GL_COPY_WRITE_BUFFER, bytes, 0);
    finder_.reset();
}

void GpuCurvature::readBy(gl::VertexArray& array) const {
    array.attribute(diagonalAttribute, buffer_, 3, sizeof(VertexCurvature),
                    offsetof(VertexCurvature, diagonal));
    array.attribute(mixedAttribute, buffer_, 3, sizeof(VertexCurvature),
                    offsetof(VertexCurvature, mixed));
}

} // namespace patina
