// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "catalog/catalog.h"
#include "render/gpu/key_table.h"
#include "render/lights/placement.h"
#include "render/plan/frame_plan.h"

namespace patina {

/// Holds what is asked of a plan, apart from its scene, view and meshes.
struct PlanWish {
    bool holdsEffects = false; ///< as while a value is dragged: places and distances decide nothing
    bool isUnseen = false;     ///< only programs are wanted: nothing lies outside the picture
};

/// Makes plans, which depend on nothing but what it is given. It remembers the placements and the
/// lowest points of the last plan, so that planning the next one computes little and allocates
/// nothing.
class FramePlanner {
  public:
    /// The plan takes the place of the last one, which is no longer valid.
    void make(FramePlan& plan, const Scene& scene, const View& view, const MeshSource& meshes,
              const Catalog& catalog, PlanWish wish = {});

  private:
    /// Holds the lowest height of an object, as long as it is the same mesh at the same place.
    struct Lowest {
        glm::dmat4 world{0.0};
        std::span<const Vertex> vertices;
        Bounds bounds;
        double height = 0.0;

        bool isOf(const DrawItem& item) const;
    };

    void collect(FramePlan& plan, const MeshSource& meshes, const Catalog& catalog);
    DrawItem itemOf(FramePlan& plan, std::size_t index, const MeshView& mesh,
                    const Catalog& catalog);
    std::size_t materialOf(FramePlan& plan, std::size_t object, std::size_t missing,
                           const Catalog& catalog);
    void addGround(FramePlan& plan);
    double lowestHeight(const DrawItem& item);

    PlacementStore placements_;
    KeyTable materialKeys_;
    std::vector<Lowest> lowest_; ///< by object
};

} // namespace patina
