// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <tuple>

#include "core/mesh.h"
#include "render/gpu/gpu_mesh.h"

namespace patina {

/// Owns the meshes in the GPU's memory. It knows a mesh by its address, its sizes and a sample of
/// its content, so that a new mesh at an old address is noticed.
class GpuMeshStore {
  public:
    /// Returns the complete mesh; uploads what is missing of it.
    const GpuMesh& get(const MeshView& mesh);

    /// Returns the mesh, which is empty when it is new and may be incomplete. It is kept as long as
    /// somebody holds the pointer.
    const std::shared_ptr<GpuMesh>& prepare(const MeshView& mesh);

    /// Returns the edges of a mesh that prepare() gave; they may be incomplete.
    GpuEdges& prepareEdges(GpuMesh& mesh, const MeshView& view) { return mesh.edges(view, frame_); }

    /// Returns the marks of a mesh that prepare() gave; they may be too few.
    GpuMarks& prepareMarks(GpuMesh& mesh, const MeshView& view) { return mesh.marks(view, frame_); }

    /// Begins a frame. Each mesh's content is sampled once between beginFrame() and endFrame().
    void beginFrame();

    /// Ends a frame and deletes meshes that were not drawn for 120 frames and that nobody holds.
    void endFrame();

  private:
    using Key = std::tuple<const void*, const void*, std::size_t, std::size_t>;
    struct Entry {
        std::shared_ptr<GpuMesh> mesh;
        std::uint64_t sample = 0;
        std::uint64_t looked = 0; ///< is the value of look_ when `sample` was taken
        std::uint64_t lastFrame = 0;
    };

    std::map<Key, Entry> meshes_;
    Key last_; ///< is the last key asked for, since objects of one mesh often follow each other
    Entry* lastEntry_ = nullptr;
    std::uint64_t frame_ = 0;
    std::uint64_t look_ = 1;
    std::uint64_t made_ = 0;
};

} // namespace patina
