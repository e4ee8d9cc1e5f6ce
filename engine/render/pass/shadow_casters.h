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

/// Holds the shadow casters of a frame.
class ShadowCasters {
  public:
    static constexpr std::size_t solid = std::numeric_limits<std::size_t>::max();

    /// Holds what decides a caster's shadow besides its place.
    struct Shape {
        std::uint64_t serial = 0; ///< is GpuMesh::serial()
        std::size_t alphaTested = solid;

        friend bool operator==(const Shape&, const Shape&) = default;
    };

    /// Holds all on which the shadows of a frame's casters depend.
    struct Record {
        std::vector<CasterBox> boxes;
        std::vector<Shape> shapes;
        std::vector<AlphaTest> alphaTests;

        friend bool operator==(const Record&, const Record&) = default;
    };

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

    std::span<const CasterBox> boxes() const { return record_.boxes; }
    std::int64_t triangles() const;

    /// Returns what prepare() has found.
    const Record& record() const { return record_; }

    /// Collects the casters that a map sees, sorted by mesh, into `runs` and `instances`.
    void gather(const glm::dmat4& worldToMap, std::vector<Run>& runs, InstanceBuffer& instances);

    /// Makes the program of an alpha-tested run current and binds its data.
    void useAlphaTest(const Run& run, const glm::mat4& worldToMap, FrameTextures& textures) {
        alphaTested_.use(run.alphaTested, worldToMap, textures);
    }

  private:
    void sortByMesh();
    bool isSeen(const glm::dmat4& worldToMap, std::size_t caster) const;

    std::shared_ptr<const Catalog> catalog_;
    std::vector<const GpuMesh*> meshes_;
    Record record_;
    AlphaTestedCasters alphaTested_;
    std::vector<std::size_t> byMesh_; ///< has the indices of casters, sorted by mesh
};

} // namespace patina
