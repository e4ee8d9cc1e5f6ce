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

/// Is one of the different materials of a frame; many objects may have it.
struct DrawMaterial {
    std::size_t object = 0;  ///< is the first object that has it
    std::size_t missing = 0; ///< is LightKinds::missingKinds() for its objects
    bool isTransparent = false;
    bool canShadow = true;
    bool isOutlined = false;                  ///< says that the edges of its objects' meshes are
                                              ///< wanted
    bool isLayered = false;                   ///< says that its objects are composed layer by layer
    std::shared_ptr<const Pipeline> pipeline; ///< is null when there is no program to draw it with
    UniformPool::Place data;
    UniformPool::Place outlineData;

    bool hasLines() const { return isOutlined && pipeline && pipeline->outline; }

    /// Returns true when its program refracts; the program may be one from before a change of the
    /// material.
    bool refracts() const { return pipeline && pipeline->object.refraction.has_value(); }
};

/// Says what is drawn of one object of a frame.
struct DrawItem {
    std::size_t index = 0; ///< is the object's index in the scene
    MeshView view;
    std::shared_ptr<GpuMesh> mesh; ///< is null until the mesh is allocated on the GPU
    const Placement* placement = nullptr;
    double distance = 0.0;    ///< metres from the eye to the middle of its box
    std::size_t lights = 0;   ///< is the number of its list in LightLists
    std::size_t material = 0; ///< is an index into FramePlan::materials
    bool isInPicture = true;
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

/// Decides the order in which a frame's objects are drawn. Opaque ones come first, grouped by
/// program, material and mesh, near groups and near objects before far ones, so that the depth test
/// hides what is behind. Transparent ones follow, far ones first and each alone, so that each is
/// blended over what is seen through it.
class DrawList {
  public:
    /// Makes the batches. Items that are not in the picture or have no program are left out; each
    /// item must have a mesh. It allocates nothing once it has had as many items.
    void order(std::span<const DrawItem> items, std::span<const DrawMaterial> materials);

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

    void addOpaque(std::span<const DrawItem> items, std::span<const DrawMaterial> materials);
    void rank(std::span<const DrawMaterial> materials);
    void sortBatches(std::span<const DrawMaterial> materials);
    void placeItems(std::span<const DrawItem> items);
    void addTransparent(std::span<const DrawItem> items, std::span<const DrawMaterial> materials);

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
