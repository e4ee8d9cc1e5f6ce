// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "core/convex_facets.h"
#include "core/mesh.h"
#include "gl/buffer.h"
#include "gl/vertex_array.h"
#include "render/gpu/gpu_curvature.h"
#include "render/gpu/gpu_edges.h"
#include "render/gpu/gpu_marks.h"
#include "render/gpu/instanced_arrays.h"

namespace patina {

/// Holds a mesh in the GPU's memory. Its attributes are 0 position, 1 normal, 2 tangent, 3 texture
/// coordinates, 4 the sign of the bitangent, then those of Instance, 11 openness, 12 and 13
/// curvature, and 14 colours. While openness is missing, nothing counts as hidden; while curvature
/// is, all is flat; while colours are, all is white.
class GpuMesh {
  public:
    /// Allocates buffers for this mesh; upload() fills them. `serial` must differ from that of any
    /// other mesh.
    explicit GpuMesh(const MeshView& mesh, std::uint64_t serial = 0);

    /// Uploads at most `bytes` more of the mesh that it was made for; `bytes` is at least 1.
    void upload(const MeshView& mesh, std::size_t bytes);
    bool isComplete() const { return uploaded_ == vertices_.size() + indices_.size(); }

    /// Uploads the openness of the mesh that it was made for, unless that is still missing or
    /// already uploaded.
    void takeOpenness(const MeshView& mesh);

    /// Uploads the colours of the mesh that it was made for, unless it has none or they are there.
    void takeColors(const MeshView& mesh);

    /// Finds and uploads some more of how it bends at its vertices, which takes some milliseconds;
    /// returns true once that is complete.
    bool takeCurvature(const MeshView& mesh);

    /// Draws a range of a mesh that is complete.
    void draw(const InstanceBuffer& instances, const DrawRange& range) const;
    /// Draws all triangles of a complete mesh for one object.
    void draw(const SingleInstance& instance) const { draw(instance.buffer(), {0, triangles_}); }
    int triangles() const { return triangles_; }
    std::uint64_t serial() const { return serial_; }

    /// Returns the edges, which may be incomplete, and notes that frame number `frame` uses them.
    GpuEdges& edges(const MeshView& mesh, std::uint64_t frame);
    void drawEdges(const InstanceBuffer& instances, const DrawRange& range) const {
        edges_->draw(vertices_, colors_ ? &*colors_ : nullptr, instances, range);
    }
    bool hasEdges() const { return edges_ && edges_->isComplete(); }
    int edgeCount() const { return edges_->count(); }

    /// Returns the marks, which may be too few, and notes that frame number `frame` uses them.
    GpuMarks& marks(const MeshView& mesh, std::uint64_t frame);
    const GpuMarks* knownMarks() const { return marks_ ? &*marks_ : nullptr; }

    /// Returns the planes of the mesh that it was made for, which it finds when they are first
    /// asked for.
    const ConvexFacets& facets(const MeshView& mesh);

    /// Deletes the edges and the marks unless frame number `frame` or a later one has asked for
    /// them.
    void forgetUnused(std::uint64_t frame);

  private:
    gl::VertexArray makeArray() const;

    mutable InstancedArrays arrays_;
    gl::Buffer vertices_ = gl::Buffer::create();
    gl::Buffer indices_ = gl::Buffer::create();
    std::optional<gl::Buffer> openness_;
    std::optional<gl::Buffer> colors_;
    std::optional<GpuCurvature> curvature_;
    std::size_t uploaded_ = 0; ///< bytes of the vertices, then of the indices
    int triangles_ = 0;
    std::uint64_t serial_ = 0;
    std::optional<GpuEdges> edges_;
    std::optional<ConvexFacets> facets_;
    std::optional<GpuMarks> marks_;
    std::uint64_t edgesFrame_ = 0; ///< is the last frame that asked for the edges
    std::uint64_t marksFrame_ = 0; ///< is the last frame that asked for the marks
};

} // namespace patina
