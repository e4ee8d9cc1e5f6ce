// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/plan/draw_list.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <tuple>

namespace patina {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Packs mesh, material and list into one key. There are fewer than 256 lists of lights
/// (LightLists::maxCount) and fewer than 2^24 materials in a frame.
std::uint64_t keyOf(const PlannedItem& item, const GpuMesh& mesh) {
    return mesh.serial() << 32 | std::uint64_t(item.material) << 8 | std::uint64_t(item.lights);
}

const void* programOf(const DrawMaterial& material) {
    return material.pipeline ? material.pipeline->program.get() : nullptr;
}

bool isDrawn(const Drawables& drawables, const PlannedItem& item, bool transparent) {
    return item.isInPicture && drawables.materials[item.material].pipeline != nullptr &&
           drawables.plan.materials[item.material].isTransparent == transparent;
}

} // namespace

void DrawList::order(const Drawables& drawables) {
    batches_.clear();
    order_.clear();
    addOpaque(drawables);
    rank(drawables.materials);
    sortBatches(drawables.materials);
    placeItems(drawables.plan.items);
    opaque_ = batches_.size();
    addTransparent(drawables);
}

/// Groups opaque items into batches, in the order of the scene.
void DrawList::addOpaque(const Drawables& drawables) {
    const std::vector<PlannedItem>& items = drawables.plan.items;
    static_assert(LightLists::maxCount < 255);
    known_.clear(items.size());
    found_.clear();
    batchOf_.assign(items.size(), 0);
    for (std::size_t i = 0; i < items.size(); ++i) {
        const PlannedItem& item = items[i];
        if (!isDrawn(drawables, item, false)) {
            continue;
        }
        GpuMesh* mesh = drawables.meshes[i].get();
        const std::size_t number = known_.find(keyOf(item, *mesh), found_.size());
        if (number == found_.size()) {
            found_.push_back({item.material, mesh, item.lights, 0, 0, infinity});
        }
        DrawBatch& batch = found_[number];
        ++batch.count;
        batch.nearest = std::min(batch.nearest, item.distance);
        batchOf_[i] = static_cast<std::uint32_t>(number + 1);
    }
}

/// Finds the distance of the nearest object of each material and of each program.
void DrawList::rank(std::span<const DrawMaterial> materials) {
    ranks_.assign(materials.size(), {infinity, infinity});
    programs_.clear();
    for (const DrawBatch& batch : found_) {
        double& nearest = ranks_[batch.material].material;
        nearest = std::min(nearest, batch.nearest);
    }
    for (std::size_t i = 0; i < materials.size(); ++i) {
        const void* program = programOf(materials[i]);
        auto known = std::ranges::find(programs_, program, &std::pair<const void*, double>::first);
        if (known == programs_.end()) {
            known = programs_.insert(known, {program, infinity});
        }
        known->second = std::min(known->second, ranks_[i].material);
    }
    for (std::size_t i = 0; i < materials.size(); ++i) {
        const void* program = programOf(materials[i]);
        ranks_[i].program =
            std::ranges::find(programs_, program, &std::pair<const void*, double>::first)->second;
    }
}

void DrawList::sortBatches(std::span<const DrawMaterial> materials) {
    const auto keyOfBatch = [&](std::uint32_t number) {
        const DrawBatch& batch = found_[number];
        const Rank& rank = ranks_[batch.material];
        return std::tuple(rank.program, programOf(materials[batch.material]), rank.material,
                          batch.material, batch.nearest, number);
    };
    sorted_.resize(found_.size());
    std::iota(sorted_.begin(), sorted_.end(), 0u);
    std::ranges::sort(sorted_, std::less<>(), keyOfBatch);
    placeOf_.resize(found_.size());
    std::size_t first = 0;
    for (std::size_t place = 0; place < sorted_.size(); ++place) {
        placeOf_[sorted_[place]] = static_cast<std::uint32_t>(place);
        DrawBatch& batch = batches_.emplace_back(found_[sorted_[place]]);
        batch.first = first;
        first += batch.count;
    }
    order_.resize(first);
}

/// Puts each item into its batch, then sorts each batch by distance.
void DrawList::placeItems(std::span<const PlannedItem> items) {
    for (DrawBatch& batch : batches_) {
        batch.count = 0;
    }
    for (std::size_t i = 0; i < items.size(); ++i) {
        if (batchOf_[i] != 0) {
            DrawBatch& batch = batches_[placeOf_[batchOf_[i] - 1]];
            order_[batch.first + batch.count++] = static_cast<std::uint32_t>(i);
        }
    }
    for (const DrawBatch& batch : batches_) {
        const auto begin = order_.begin() + static_cast<std::ptrdiff_t>(batch.first);
        std::sort(begin, begin + static_cast<std::ptrdiff_t>(batch.count),
                  [items](std::uint32_t a, std::uint32_t b) {
                      return std::tie(items[a].distance, a) < std::tie(items[b].distance, b);
                  });
    }
}

void DrawList::addTransparent(const Drawables& drawables) {
    const std::vector<PlannedItem>& items = drawables.plan.items;
    const std::size_t first = order_.size();
    for (std::size_t i = 0; i < items.size(); ++i) {
        if (isDrawn(drawables, items[i], true)) {
            order_.push_back(static_cast<std::uint32_t>(i));
        }
    }
    std::sort(order_.begin() + static_cast<std::ptrdiff_t>(first), order_.end(),
              [&items](std::uint32_t a, std::uint32_t b) {
                  return std::tie(items[b].distance, a) < std::tie(items[a].distance, b);
              });
    for (std::size_t i = first; i < order_.size(); ++i) {
        const PlannedItem& item = items[order_[i]];
        GpuMesh* mesh = drawables.meshes[order_[i]].get();
        batches_.push_back({item.material, mesh, item.lights, i, 1, item.distance});
    }
}

} // namespace patina
