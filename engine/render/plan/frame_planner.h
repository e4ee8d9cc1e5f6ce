// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "catalog/catalog.h"
#include "render/gpu/key_table.h"
#include "render/lights/placement.h"
#include "render/plan/frame_plan.h"

namespace patina {

/// Holds the options of a plan.
struct PlanWish {
    bool freezesEffects = false; ///< keeps the effects while a value is dragged: positions and
                                 ///< distances do not change them
    bool isUnseen = false; ///< is for a frame that only compiles programs: no object counts as
                           ///< outside the picture
};

/// Makes plans, which depend only on its arguments. It remembers the placements and the lowest
/// points of the last plan, so that the next one computes little and allocates nothing.
class FramePlanner {
  public:
    /// Fills `plan`. It invalidates the last plan, whose placements are reused.
    void make(FramePlan& plan, const Scene& scene, const View& view, const MeshSource& meshes,
              const Catalog& catalog, PlanWish wish = {});

  private:
    /// Remembers the lowest height of an object, with the mesh and transform that it is valid for.
    struct Lowest {
        glm::dmat4 world{0.0};
        std::span<const Vertex> vertices;
        Bounds bounds;
        double height = 0.0;

        bool isOf(const PlannedItem& item) const;
    };

    void collect(FramePlan& plan, const MeshSource& meshes, const Catalog& catalog);
    PlannedItem itemOf(FramePlan& plan, std::size_t index, const MeshView& mesh,
                       const Catalog& catalog);
    std::size_t materialOf(FramePlan& plan, std::size_t object, std::size_t missing,
                           const Catalog& catalog);
    void addGround(FramePlan& plan);
    double lowestHeight(const PlannedItem& item);

    PlacementStore placements_;
    KeyTable materialKeys_;
    std::vector<Lowest> lowest_; ///< has one for each object of the scene
};

} // namespace patina
