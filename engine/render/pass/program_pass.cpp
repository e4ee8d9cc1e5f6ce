// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/pass/program_pass.h"

#include <algorithm>

#include <boost/container_hash/hash.hpp>

#include "render/pass/frame_gpu.h"
#include "shading/effects/material_hash.h"

namespace patina {
namespace {

void note(PreparedFrame& frame, const void* source) {
    if (std::ranges::find(frame.sources, source) == frame.sources.end()) {
        frame.sources.push_back(source);
    }
}

} // namespace

Result<bool> ProgramPass::prepare(PreparedFrame& frame, FrameGpu& gpu) {
    ProgramCache& programs = gpu.shared.programs();
    const int built = programs.builtCount();
    sceneKeys_.clear();
    frame.sources.clear();
    if (lastGood_.size() < frame.plan.effects->objects.size()) {
        lastGood_.resize(frame.plan.effects->objects.size());
    }
    for (std::size_t i = 0; i < frame.materials.size(); ++i) {
        choose(frame, i, gpu.shared);
        if (programs.builtCount() > built) {
            return true;
        }
    }
    for (const PlannedItem& item : frame.plan.items) {
        const std::shared_ptr<const Pipeline>& chosen = frame.materials[item.material].pipeline;
        if (lastGood_[item.index] != chosen) {
            lastGood_[item.index] = chosen;
        }
    }
    chooseGround(frame, gpu.shared);
    return false;
}

/// Returns the surroundings of objects that these kinds of lights do not reach.
PipelineStore::Surroundings ProgramPass::surroundings(const FramePlan& plan, std::size_t missing,
                                                      const Catalog& catalog) {
    EffectView view = plan.effectView;
    view.unreached = plan.lightKinds.lights(missing);
    auto known =
        std::ranges::find(sceneKeys_, missing, &std::pair<std::size_t, std::uint64_t>::first);
    if (known == sceneKeys_.end()) {
        known = sceneKeys_.insert(known, {missing, keys_.ofScene(*plan.effects, catalog, view)});
    }
    return {*plan.effects, known->second, view};
}

const PipelineStore::Entry& ProgramPass::entryOf(const FramePlan& plan,
                                                 const PlannedMaterial& material,
                                                 RenderResources& shared) {
    const Material& effects = plan.effects->objects[material.object].material;
    return shared.pipelines.get(effects, EffectKey::ofMaterial(effects, *shared.catalog),
                                surroundings(plan, material.missing, *shared.catalog));
}

/// Sets the program of a material: its own, else the last good one of the object, else a plain
/// fallback.
void ProgramPass::choose(PreparedFrame& frame, std::size_t number, RenderResources& shared) {
    const PlannedMaterial& planned = frame.plan.materials[number];
    DrawMaterial& material = frame.materials[number];
    const PipelineStore::Entry& entry = entryOf(frame.plan, planned, shared);
    material.pipeline = entry.pipeline ? entry.pipeline : lastGood_[planned.object];
    if (!entry.pipeline) {
        note(frame, &entry);
    }
    if (!material.pipeline) {
        const PipelineStore::Entry& fallback =
            shared.pipelines.fallback(surroundings(frame.plan, planned.missing, *shared.catalog));
        material.pipeline = fallback.pipeline;
        if (!fallback.pipeline) {
            note(frame, &fallback);
        }
    }
    if (material.pipeline) {
        note(frame, material.pipeline.get());
    }
}

void ProgramPass::chooseGround(PreparedFrame& frame, RenderResources& shared) {
    frame.ground.reset();
    if (!frame.plan.ground.isSeen) {
        return;
    }
    const PipelineStore::Entry& entry = shared.pipelines.ground(
        surroundings(frame.plan, frame.plan.ground.missing, *shared.catalog));
    lastGround_ = entry.pipeline ? entry.pipeline : lastGround_;
    if (lastGround_ && lastGround_->effects.ground != GroundMode::Off) {
        frame.ground = lastGround_;
        note(frame, lastGround_.get());
    }
}

std::size_t ProgramPass::missing(const FramePlan& plan, RenderResources& shared) {
    sceneKeys_.clear();
    std::size_t missing = 0;
    for (const PlannedMaterial& material : plan.materials) {
        const std::uint64_t key =
            EffectKey::ofMaterial(plan.effects->objects[material.object].material, *shared.catalog);
        const std::uint64_t around = surroundings(plan, material.missing, *shared.catalog).key;
        if (!shared.pipelines.has(key, around)) {
            boost::hash_combine(missing, key);
            boost::hash_combine(missing, around);
        }
    }
    if (plan.ground.isSeen) {
        const std::uint64_t around = surroundings(plan, plan.ground.missing, *shared.catalog).key;
        if (!shared.pipelines.hasGround(plan.effects->ground.mode, around)) {
            boost::hash_combine(missing, 1);
            boost::hash_combine(missing, around);
        }
    }
    return missing;
}

bool ProgramPass::hasFrozen(const FramePlan& plan, RenderResources& shared) {
    const Catalog& catalog = *shared.catalog;
    const Scene& effects = *plan.effects;
    EffectView frozen;
    frozen.fitsEnvironment = plan.effectView.fitsEnvironment;
    const std::uint64_t sceneKey = keys_.ofScene(effects, catalog, frozen);
    if (isSeen(effects.ground) && !shared.pipelines.hasGround(effects.ground.mode, sceneKey)) {
        return false;
    }
    std::size_t known = 0;
    known_.clear(effects.objects.size());
    return std::ranges::all_of(effects.objects, [&](const Object& object) {
        if (!object.visible || known_.find(materialHash(object.material), known) < known) {
            return true;
        }
        ++known;
        return shared.pipelines.has(EffectKey::ofMaterial(object.material, catalog), sceneKey);
    });
}

} // namespace patina
