// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/gpu/gpu_marks.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>

#include <epoxy/gl.h>

namespace patina {
namespace {

/// Takes some milliseconds.
constexpr std::size_t dartsAtOnce = 2048;

constexpr std::size_t minCount = 256;

/// Reads a mark's vertex as passes/surface.vert does, once per instance; 12 is `needed`,
/// and `bend` behind it.
void markAttributes(gl::VertexArray& array, const gl::Buffer& marks, std::size_t first) {
    constexpr std::size_t size = sizeof(SurfaceMark);
    const auto read = [&](unsigned location, int components, std::size_t offset) {
        array.attribute(location, marks, components, size, first * size + offset);
        glVertexAttribDivisor(location, 1);
    };
    read(0, 3, offsetof(SurfaceMark, at) + offsetof(Vertex, position));
    read(1, 3, offsetof(SurfaceMark, at) + offsetof(Vertex, normal));
    read(2, 3, offsetof(SurfaceMark, at) + offsetof(Vertex, tangent));
    read(3, 2, offsetof(SurfaceMark, at) + offsetof(Vertex, uv));
    read(4, 1, offsetof(SurfaceMark, at) + offsetof(Vertex, tangent) + offsetof(glm::vec4, w));
    read(12, 2, offsetof(SurfaceMark, needed));
}

} // namespace

GpuMarks::GpuMarks(const MeshView& mesh) : marks_(std::make_unique<SurfaceMarks>(mesh)) {}

/// Grows by powers of two, so that a camera that comes nearer rarely needs more.
std::size_t GpuMarks::wanted(double perArea) const {
    const double wanted = std::min(perArea * marks_->area(), double(SurfaceMarks::maxCount));
    const auto whole = static_cast<std::size_t>(std::max(wanted, double(minCount)));
    return std::min(std::bit_ceil(whole), SurfaceMarks::maxCount);
}

bool GpuMarks::hasEnough(double perArea) const {
    return marks_->isMeasured() && (!(marks_->area() > 0.0) || uploaded_ >= wanted(perArea));
}

void GpuMarks::proceed(const MeshView& mesh, double perArea) {
    const std::size_t last = marks_->isMeasured() ? wanted(perArea) : 0;
    marks_->proceed(mesh, dartsAtOnce, last);
    if (last > 0 && marks_->marks().size() >= last) {
        upload();
    }
}

void GpuMarks::upload() {
    // A vertex array does not record this target.
    const auto bytes = std::as_bytes(marks_->marks());
    buffer_.reserve(GL_COPY_WRITE_BUFFER, bytes.size(), gl::Buffer::Content::Lasting);
    buffer_.write(GL_COPY_WRITE_BUFFER, bytes);
    uploaded_ = marks_->marks().size();
}

std::size_t GpuMarks::count(double perArea) const {
    const double wanted = std::min(perArea * marks_->area(), double(uploaded_));
    return std::min(static_cast<std::size_t>(std::ceil(wanted)), uploaded_);
}

double GpuMarks::available() const {
    return marks_->area() > 0.0 ? double(uploaded_) / marks_->area() : 0.0;
}

void GpuMarks::draw(const InstanceBuffer& instances, const MarkRange& range) const {
    array_.bind();
    markAttributes(array_, buffer_, range.first);
    array_.instanced(Instance::firstAttribute, *instances.buffer(), Instance::attributes,
                     range.instance * sizeof(Instance), static_cast<unsigned>(range.count));
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(range.count));
}

} // namespace patina
