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

/// Knows what casts shadows in a frame, and whether that has changed since the depth maps were
/// drawn.
class ShadowCasters {
  public:
    static constexpr std::size_t solid = std::numeric_limits<std::size_t>::max();

    /// Casters of one mesh that a map shows, all solid or one alpha-tested.
    struct Run {
        const GpuMesh* mesh = nullptr;
        std::size_t first = 0; ///< of its instances
        std::size_t count = 0;
        std::size_t alphaTested = solid; ///< its number among AlphaTestedCasters
    };

    void setCatalog(std::shared_ptr<const Catalog> catalog);

    /// Begins a frame.
    void clear();
    void add(const GpuMesh& mesh, const CasterBox& box, const Material& material);

    /// Makes the programs of those that are alpha-tested.
    Result<void> prepare(ProgramCache& programs, const GpuTextureStore& textures);

    std::span<const CasterBox> boxes() const { return boxes_; }
    std::int64_t triangles() const;

    /// Tells whether they are others, or stand elsewhere, than at noteDrawn().
    bool hasChanged() const;
    void noteDrawn();

    /// Those that a map sees, sorted by mesh.
    void gather(const glm::dmat4& worldToMap, std::vector<Run>& runs, InstanceBuffer& instances);

    /// Uses the program for an alpha-tested run.
    void useAlphaTest(const Run& run, const glm::mat4& worldToMap, FrameTextures& textures) {
        alphaTested_.use(run.alphaTested, worldToMap, textures);
    }

  private:
    /// Holds what of a caster decides its shadow, beside where it stands.
    struct Shape {
        std::uint64_t serial = 0; ///< of its mesh
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
    std::vector<std::size_t> byMesh_; ///< the casters, those of one mesh together
};

} // namespace patina
