// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "render/gpu/gpu_mesh.h"
#include "render/lights/shadow_view.h"
#include "render/pass/alpha_tested_casters.h"

namespace patina {

/// Holds the shadow casters of a frame, and knows whether they have changed since the shadow maps
/// were drawn.
class ShadowCasters {
  public:
    static constexpr std::size_t solid = std::numeric_limits<std::size_t>::max();

    /// Is a run of casters of one mesh that a map sees. Either all are solid, or all have the same
    /// alpha-tested material.
    struct Run {
        const GpuMesh* mesh = nullptr;
        std::size_t first = 0; ///< is the index of its first instance
        std::size_t count = 0;
        std::size_t alphaTested = solid; ///< is its index in AlphaTestedCasters, or `solid`
    };

    void setCatalog(std::shared_ptr<const Catalog> catalog);

    /// Begins a frame.
    void clear();
    void add(const GpuMesh& mesh, const CasterBox& box, const Material& material);

    /// Makes the programs of alpha-tested casters; fails when one does not compile.
    Result<void> prepare(ProgramCache& programs, const GpuTextureStore& textures);

    std::span<const CasterBox> boxes() const { return boxes_; }
    std::int64_t triangles() const;

    /// Returns true when any caster differs in shape or place from noteDrawn().
    bool hasChanged() const;
    void noteDrawn();

    /// Collects the casters that a map sees, sorted by mesh, into `runs` and `instances`.
    void gather(const glm::dmat4& worldToMap, std::vector<Run>& runs, InstanceBuffer& instances);

    /// Makes the program of an alpha-tested run current and binds its data.
    void useAlphaTest(const Run& run, const glm::mat4& worldToMap, FrameTextures& textures) {
        alphaTested_.use(run.alphaTested, worldToMap, textures);
    }

  private:
    /// Holds what decides a caster's shadow besides its place.
    struct Shape {
        std::uint64_t serial = 0; ///< is GpuMesh::serial()
        std::size_t alphaTested = solid;

        friend bool operator==(const Shape&, const Shape&) = default;
    };

    void sortByMesh();
    bool isSeen(const glm::dmat4& worldToMap, std::size_t caster) const;

    std::shared_ptr<const Catalog> catalog_;
    std::vector<const GpuMesh*> meshes_;
    std::vector<CasterBox> boxes_;
    std::vector<Shape> shapes_;
    AlphaTestedCasters alphaTested_;
    std::vector<CasterBox> drawnBoxes_;
    std::vector<Shape> drawnShapes_;
    std::vector<std::size_t> byMesh_; ///< has the indices of casters, sorted by mesh
};

} // namespace patina
