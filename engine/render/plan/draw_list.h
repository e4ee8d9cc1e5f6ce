// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "render/gpu/gpu_mesh.h"
#include "render/gpu/key_table.h"
#include "render/gpu/pipeline.h"
#include "render/gpu/uniform_pool.h"
#include "render/plan/frame_plan.h"

namespace patina {

/// Is what one of the different materials of a plan is drawn with.
struct DrawMaterial {
    std::shared_ptr<const Pipeline> pipeline; ///< is null when there is no program to draw it with
    UniformPool::Place data;
    UniformPool::Place outlineData;
    bool isLayered = false; ///< says that its objects are composed layer by layer

    /// Returns true when its program refracts; the program may be one from before a change of the
    /// material.
    bool refracts() const { return pipeline && pipeline->object.refraction.has_value(); }
};

/// Holds objects that are drawn with one call: they have the same mesh, material and list of
/// lights. A transparent object is alone in its batch.
struct DrawBatch {
    std::size_t material = 0;
    GpuMesh* mesh = nullptr; ///< is the mesh of all items
    std::size_t lights = 0;
    std::size_t first = 0; ///< is the index of the first item in DrawList::items()
    std::size_t count = 0;
    double nearest = 0.0; ///< metres from the eye to the nearest item
};

/// Is what a frame's order of drawing is made of: a plan, and for each of its items a mesh and for
/// each of its materials a program.
struct Drawables {
    const FramePlan& plan;
    std::span<const std::shared_ptr<GpuMesh>> meshes;
    std::span<const DrawMaterial> materials;
};

/// Decides the order in which a frame's objects are drawn. Opaque ones come first, grouped by
/// program, material and mesh, near groups and near objects before far ones, so that the depth test
/// hides what is behind. Transparent ones follow, far ones first and each alone, so that each is
/// blended over what is seen through it.
class DrawList {
  public:
    /// Makes the batches. Items that are not in the picture or have no program are left out; each
    /// item must have a mesh. It allocates nothing once it has had as many items.
    void order(const Drawables& drawables);

    std::span<const DrawBatch> batches() const { return batches_; }
    std::size_t opaqueBatches() const { return opaque_; }
    std::span<const DrawBatch> transparentBatches() const { return batches().subspan(opaque_); }

    /// Returns the indices of all drawn items in the order of drawing.
    std::span<const std::uint32_t> items() const { return order_; }

  private:
    struct Rank {
        double program = 0.0; ///< metres to the nearest object with the program
        double material = 0.0;
    };

    void addOpaque(const Drawables& drawables);
    void rank(std::span<const DrawMaterial> materials);
    void sortBatches(std::span<const DrawMaterial> materials);
    void placeItems(std::span<const PlannedItem> items);
    void addTransparent(const Drawables& drawables);

    KeyTable known_;
    std::vector<DrawBatch> batches_;
    std::size_t opaque_ = 0;
    std::vector<std::uint32_t> order_;
    std::vector<std::uint32_t> batchOf_; ///< has for each item the index of its batch in found_ +
                                         ///< 1; 0 for none
    std::vector<std::uint32_t> sorted_;  ///< has the indices of found_ in the order of drawing
    std::vector<std::uint32_t> placeOf_; ///< has for each batch of found_ its index in batches_
    std::vector<DrawBatch> found_;
    std::vector<Rank> ranks_; ///< has one for each material
    std::vector<std::pair<const void*, double>> programs_;
};

} // namespace patina
