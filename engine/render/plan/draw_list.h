// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/mesh.h"
#include "render/gpu/gpu_mesh.h"
#include "render/gpu/key_table.h"
#include "render/gpu/pipeline.h"
#include "render/gpu/uniform_pool.h"
#include "render/lights/placement.h"

namespace patina {

/// One of the different materials of a frame, however many objects have it.
struct DrawMaterial {
    std::size_t object = 0;  ///< the first one that has it
    std::size_t missing = 0; ///< of lights, LightKinds::missingKinds() for its objects
    bool isTransparent = false;
    bool canShadow = true;
    bool isOutlined = false;                  ///< its objects' meshes have edges
    bool isLayered = false;                   ///< its objects are put together layer by layer
    std::shared_ptr<const Pipeline> pipeline; ///< null: there is nothing to draw it with
    UniformPool::Place data;
    UniformPool::Place outlineData;

    bool hasLines() const { return isOutlined && pipeline && pipeline->outline; }

    /// Asks the program that it is drawn with, which may be left over from before a change.
    bool refracts() const { return pipeline && pipeline->object.refraction.has_value(); }
};

/// Says what is drawn of one object of a frame.
struct DrawItem {
    std::size_t index = 0; ///< in the scene
    MeshView view;
    std::shared_ptr<GpuMesh> mesh; ///< null until the GPU has room for it
    const Placement* placement = nullptr;
    double distance = 0.0;    ///< from the eye to the middle of its box
    std::size_t lights = 0;   ///< the number of its list
    std::size_t material = 0; ///< among the frame's
    bool isInPicture = true;
};

/// Holds what is drawn with one call: the same mesh, material and list of lights. Of transparent
/// objects there is one in each.
struct DrawBatch {
    std::size_t material = 0;
    GpuMesh* mesh = nullptr; ///< the items'
    std::size_t lights = 0;
    std::size_t first = 0; ///< in DrawList::items()
    std::size_t count = 0;
    double nearest = 0.0; ///< distance of the nearest one
};

/// Holds the order in which a frame's objects are drawn. What hides comes first, by program,
/// material and mesh; of each of these the nearest first, and near objects of a batch before far
/// ones, so that depth hides what is behind. Then the others, far ones first, each alone, so that
/// each is blended over what is seen through it.
class DrawList {
  public:
    /// Items that are not in the picture or have no program are left out; all have a mesh.
    /// Allocates nothing once it has had as many.
    void order(std::span<const DrawItem> items, std::span<const DrawMaterial> materials);

    std::span<const DrawBatch> batches() const { return batches_; }
    std::size_t opaqueBatches() const { return opaque_; }
    std::span<const DrawBatch> transparentBatches() const { return batches().subspan(opaque_); }

    /// Returns the numbers of all items in the order of drawing.
    std::span<const std::uint32_t> items() const { return order_; }

  private:
    struct Rank {
        double program = 0.0; ///< distance of the nearest object
        double material = 0.0;
    };

    void addOpaque(std::span<const DrawItem> items, std::span<const DrawMaterial> materials);
    void rank(std::span<const DrawMaterial> materials);
    void sortBatches(std::span<const DrawMaterial> materials);
    void placeItems(std::span<const DrawItem> items);
    void addTransparent(std::span<const DrawItem> items, std::span<const DrawMaterial> materials);

    KeyTable known_;
    std::vector<DrawBatch> batches_;
    std::size_t opaque_ = 0;
    std::vector<std::uint32_t> order_;
    std::vector<std::uint32_t> batchOf_; ///< by item: its batch + 1 as it was found; 0: none
    std::vector<std::uint32_t> sorted_;  ///< by place: the batch as it was found
    std::vector<std::uint32_t> placeOf_; ///< by batch as it was found: its place
    std::vector<DrawBatch> found_;
    std::vector<Rank> ranks_; ///< by material
    std::vector<std::pair<const void*, double>> programs_;
};

} // namespace patina
