// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "render/gpu/key_table.h"
#include "render/pass/pass.h"
#include "render/pass/pipeline_store.h"
#include "render/plan/frame_plan.h"
#include "shading/effects/effect_key.h"

namespace patina {

struct RenderResources;

/// Chooses the programs of a frame's materials and of its ground: those of their effects, and the
/// last good ones where these do not compile.
class ProgramPass : public Pass {
  public:
    /// Returns those of all, unless one had to be made: the next call goes on then.
    Result<bool> prepare(FramePlan& plan, FrameGpu& gpu) override;

    /// 0 when all programs of a plan are there, else a number that is the same while the same ones
    /// are missing.
    std::size_t missing(const FramePlan& plan, RenderResources& shared);

    /// Tells whether those are there that a drag is drawn with, in which places and distances
    /// decide nothing.
    bool hasHeld(const FramePlan& plan, RenderResources& shared);

    /// Returns what the program of a material is, as it was chosen; there may be none but messages.
    const PipelineStore::Entry& entryOf(const FramePlan& plan, const DrawMaterial& material,
                                        RenderResources& shared);

  private:
    void choose(FramePlan& plan, DrawMaterial& material, RenderResources& shared);
    void chooseGround(FramePlan& plan, RenderResources& shared);
    PipelineStore::Surroundings surroundings(const FramePlan& plan, std::size_t missing,
                                             const Catalog& catalog);

    EffectKey keys_;
    std::vector<std::pair<std::size_t, std::uint64_t>> sceneKeys_; ///< by DrawMaterial::missing
    std::vector<std::shared_ptr<const Pipeline>> lastGood_;        ///< by object
    std::shared_ptr<const Pipeline> lastGround_;
    KeyTable known_;
};

} // namespace patina
