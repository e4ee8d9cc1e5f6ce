// SPDX-License-Identifier: GPL-3.0-or-later
// The part of FrameDrawer that chooses the programs.
#include <algorithm>

#include "render/frame_drawer.h"

namespace patina {

void FrameDrawer::choosePipelines() {
    const int before = pipelines_.programs().compiledCount();
    const PipelineStore::Surroundings around = surroundings();
    sources_.clear();
    for (const Item& item : items_) {
        choosePipeline(effects_->objects[item.index].material, slots_[item.index], around);
    }
    chooseGround(around);
    report_.compiled += pipelines_.programs().compiledCount() - before;
}

/// While a value is dragged its depth decides nothing.
PipelineStore::Surroundings FrameDrawer::surroundings() {
    const EffectView view = heldEffects_ ? EffectView() : effectView(depths_);
    return {*effects_, keys_.ofScene(*effects_, *catalog_, view), view};
}

void FrameDrawer::choosePipeline(const Material& material, Slot& slot,
                                 const PipelineStore::Surroundings& around) {
    const std::uint64_t key = EffectKey::ofMaterial(material, *catalog_);
    const PipelineStore::Entry& entry = pipelines_.get(material, key, around);
    if (entry.pipeline) {
        slot.pipeline = entry.pipeline;
    } else {
        noteSource(&entry);
    }
    if (!slot.pipeline) {
        const PipelineStore::Entry& standIn = pipelines_.standIn(around);
        slot.pipeline = standIn.pipeline;
        if (!standIn.pipeline) {
            noteSource(&standIn);
        }
    }
    if (slot.pipeline) {
        slot.data.reserve(static_cast<std::size_t>(slot.pipeline->object.vec4s));
        noteSource(slot.pipeline.get());
    }
}

void FrameDrawer::noteSource(const void* source) {
    if (std::find(sources_.begin(), sources_.end(), source) == sources_.end()) {
        sources_.push_back(source);
    }
}

} // namespace patina
