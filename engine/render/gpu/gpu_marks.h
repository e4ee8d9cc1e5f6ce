// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>

#include "core/surface_marks.h"
#include "gl/buffer.h"
#include "gl/vertex_array.h"
#include "render/gpu/instance_buffer.h"

namespace patina {

/// Selects marks of one object.
struct MarkRange {
    std::size_t instance = 0; ///< is the object's number in an InstanceBuffer
    std::size_t first = 0;
    std::size_t count = 0;
};

/// Holds marks on a mesh in the GPU's memory, 56 bytes each: those that are set first, as many as
/// somebody needs, at most SurfaceMarks::maxCount.
class GpuMarks {
  public:
    explicit GpuMarks(const MeshView& mesh);

    /// Sets some more marks, which takes some milliseconds, or uploads them. It is called until
    /// hasEnough().
    void proceed(const MeshView& mesh, double perArea);
    bool hasEnough(double perArea) const;

    /// Returns how many of the marks are drawn when `perArea` of them are wanted on a square metre.
    std::size_t count(double perArea) const;

    /// Returns how many marks there are on a square metre, when all are drawn.
    double available() const;

    /// Returns whether there are as many marks as a mesh may have.
    bool isFull() const { return uploaded_ == SurfaceMarks::maxCount; }

    /// Draws a rectangle for each mark of a range, with the program in use.
    void draw(const InstanceBuffer& instances, const MarkRange& range) const;

  private:
    std::size_t wanted(double perArea) const;
    void upload();

    std::unique_ptr<SurfaceMarks> marks_;
    gl::Buffer buffer_ = gl::Buffer::create();
    std::size_t uploaded_ = 0; ///< counts the marks in the buffer
    mutable gl::VertexArray array_ = gl::VertexArray::create();
};

} // namespace patina
