// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <tuple>

#include "core/mesh.h"
#include "render/gpu/gpu_mesh.h"

namespace patina {

/// Holds the meshes that are in the GPU's memory. They are told apart by where they lie in memory,
/// their sizes and a sample of their content, so that a new mesh at an old address is seen.
class GpuMeshStore {
  public:
    /// Returns the mesh, and uploads it when it is not there yet.
    const GpuMesh& get(const MeshView& mesh);

    /// Returns the mesh, with room for its content when it is new; it may be incomplete. It stays
    /// for as long as somebody holds it.
    const std::shared_ptr<GpuMesh>& prepare(const MeshView& mesh);

    /// Returns the edges of a mesh that prepare() gave; they may be incomplete.
    GpuEdges& prepareEdges(GpuMesh& mesh, const MeshView& view) {
        return mesh.edges(view, frame_);
    }

    /// Call once per frame: contents are looked at once between its two ends.
    void beginFrame();

    /// Call once per frame: forgets what was not drawn for a while and nobody holds.
    void endFrame();

  private:
    using Key = std::tuple<const void*, const void*, std::size_t, std::size_t>;
    struct Entry {
        std::shared_ptr<GpuMesh> mesh;
        std::uint64_t sample = 0;
        std::uint64_t looked = 0; ///< in which frame that was made
        std::uint64_t lastFrame = 0;
    };

    std::map<Key, Entry> meshes_;
    Key last_; ///< objects of the same mesh often follow each other
    Entry* lastEntry_ = nullptr;
    std::uint64_t frame_ = 0;
    std::uint64_t look_ = 1;
    std::uint64_t made_ = 0;
};

} // namespace patina
