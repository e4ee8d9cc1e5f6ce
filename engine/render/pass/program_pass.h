// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "render/gpu/key_table.h"
#include "render/pass/pass.h"
#include "render/pass/pipeline_store.h"
#include "render/plan/prepared_frame.h"
#include "shading/effects/effect_key.h"

namespace patina {

struct RenderResources;

/// Chooses the programs of a frame's materials and of its ground by their effects. Where one does
/// not compile, the last good one is kept.
class ProgramPass : public Pass {
  public:
    /// Chooses the programs of all materials and the ground. Returns true after each program that
    /// had to be compiled; then it must be called again.
    Result<bool> prepare(PreparedFrame& frame, FrameGpu& gpu) override;

    /// Returns 0 when all programs of a plan are there, else a hash of those that are missing.
    std::size_t missing(const FramePlan& plan, RenderResources& shared);

    /// Returns true when all programs are there for drawing while a value is dragged
    /// (PlanWish::freezesEffects).
    bool hasFrozen(const FramePlan& plan, RenderResources& shared);

    /// Returns the store's entry for a material; it has errors instead of a program when that does
    /// not compile.
    const PipelineStore::Entry& entryOf(const FramePlan& plan, const PlannedMaterial& material,
                                        RenderResources& shared);

  private:
    void choose(PreparedFrame& frame, std::size_t number, RenderResources& shared);
    void chooseGround(PreparedFrame& frame, RenderResources& shared);
    PipelineStore::Surroundings surroundings(const FramePlan& plan, std::size_t missing,
                                             const Catalog& catalog);

    EffectKey keys_;
    std::vector<std::pair<std::size_t, std::uint64_t>>
        sceneKeys_;                                         ///< maps PlannedMaterial::missing
                                                            ///< to a key
    std::vector<std::shared_ptr<const Pipeline>> lastGood_; ///< has one for each object
    std::shared_ptr<const Pipeline> lastGround_;
    KeyTable known_;
};

} // namespace patina
