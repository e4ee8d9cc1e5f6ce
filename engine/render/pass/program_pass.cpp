// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/pass/program_pass.h"

#include <algorithm>

#include <boost/container_hash/hash.hpp>

#include "render/pass/frame_gpu.h"
#include "shading/effects/material_hash.h"

namespace patina {
namespace {

void note(FramePlan& plan, const void* source) {
    if (std::ranges::find(plan.sources, source) == plan.sources.end()) {
        plan.sources.push_back(source);
    }
}

} // namespace

Result<bool> ProgramPass::prepare(FramePlan& plan, FrameGpu& gpu) {
    ProgramCache& programs = gpu.shared.programs();
    const int built = programs.builtCount();
    sceneKeys_.clear();
    plan.sources.clear();
    if (lastGood_.size() < plan.effects->objects.size()) {
        lastGood_.resize(plan.effects->objects.size());
    }
    for (DrawMaterial& material : plan.materials) {
        choose(plan, material, gpu.shared);
        if (programs.builtCount() > built) {
            return true;
        }
    }
    for (const DrawItem& item : plan.items) {
        const std::shared_ptr<const Pipeline>& chosen = plan.materials[item.material].pipeline;
        if (lastGood_[item.index] != chosen) {
            lastGood_[item.index] = chosen;
        }
    }
    chooseGround(plan, gpu.shared);
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

const PipelineStore::Entry&
ProgramPass::entryOf(const FramePlan& plan, const DrawMaterial& material, RenderResources& shared) {
    const Material& effects = plan.effects->objects[material.object].material;
    return shared.pipelines.get(effects, EffectKey::ofMaterial(effects, *shared.catalog),
                                surroundings(plan, material.missing, *shared.catalog));
}

/// Sets the program of a material: its own, else the last good one of the object, else a plain
/// fallback.
void ProgramPass::choose(FramePlan& plan, DrawMaterial& material, RenderResources& shared) {
    const PipelineStore::Entry& entry = entryOf(plan, material, shared);
    material.pipeline = entry.pipeline ? entry.pipeline : lastGood_[material.object];
    if (!entry.pipeline) {
        note(plan, &entry);
    }
    if (!material.pipeline) {
        const PipelineStore::Entry& fallback =
            shared.pipelines.fallback(surroundings(plan, material.missing, *shared.catalog));
        material.pipeline = fallback.pipeline;
        if (!fallback.pipeline) {
            note(plan, &fallback);
        }
    }
    if (material.pipeline) {
        note(plan, material.pipeline.get());
    }
}

void ProgramPass::chooseGround(FramePlan& plan, RenderResources& shared) {
    plan.ground.pipeline.reset();
    if (!plan.ground.isSeen) {
        return;
    }
    const PipelineStore::Entry& entry =
        shared.pipelines.ground(surroundings(plan, plan.ground.missing, *shared.catalog));
    lastGround_ = entry.pipeline ? entry.pipeline : lastGround_;
    if (lastGround_ && lastGround_->effects.ground != GroundMode::Off) {
        plan.ground.pipeline = lastGround_;
        note(plan, lastGround_.get());
    }
}

std::size_t ProgramPass::missing(const FramePlan& plan, RenderResources& shared) {
    sceneKeys_.clear();
    std::size_t missing = 0;
    for (const DrawMaterial& material : plan.materials) {
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
