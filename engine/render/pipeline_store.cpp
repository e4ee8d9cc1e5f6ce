// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/pipeline_store.h"

#include <algorithm>

#include <glm/vec4.hpp>

#include "gl/driver.h"
#include "render/binding.h"
#include "render/environment_units.h"
#include "shading/program_source.h"
#include "shading/texture_writer.h"

namespace patina {

PipelineStore::PipelineStore(std::filesystem::path programCache, SurfaceOutput output)
    : programs_(std::move(programCache)), output_(output),
      sceneCapacity_(std::clamp(gl::largestUniformBlock() / int(sizeof(glm::vec4)),
                                SceneLayout::leastCapacity, SceneLayout::mostCapacity)) {}

void PipelineStore::setCatalog(std::shared_ptr<const Catalog> catalog) {
    catalog_ = std::move(catalog);
    entries_.clear();
}

const PipelineStore::Entry& PipelineStore::get(const Material& material, std::uint64_t materialKey,
                                               const Scene& scene, std::uint64_t sceneKey) {
    return find({materialKey, sceneKey}, material, scene);
}

const PipelineStore::Entry& PipelineStore::standIn(const Scene& scene, std::uint64_t sceneKey) {
    static const Material nothing;
    return find({0, sceneKey}, nothing, scene);
}

const PipelineStore::Entry& PipelineStore::ground(const Scene& scene, std::uint64_t sceneKey) {
    const Key key{1 + static_cast<std::uint64_t>(scene.ground.mode), sceneKey};
    auto known = entries_.find(key);
    if (known == entries_.end()) {
        known = entries_.emplace(key, make(groundEffects(scene, *catalog_), sceneKey)).first;
    }
    return known->second;
}

const PipelineStore::Entry& PipelineStore::find(const Key& key, const Material& material,
                                                const Scene& scene) {
    auto known = entries_.find(key);
    if (known == entries_.end()) {
        Entry made = make(effectSet(material, scene, *catalog_), key.second);
        known = entries_.emplace(key, std::move(made)).first;
    }
    return known->second;
}

PipelineStore::Entry PipelineStore::make(EffectSet effects, std::uint64_t sceneKey) {
    auto pipeline = std::make_shared<Pipeline>();
    const auto source = surfaceProgram(effects, *catalog_, output_, sceneCapacity_);
    if (!source) {
        return {nullptr, source.error()};
    }
    const ProgramCache::Found found = programs_.get(*source);
    if (!found.program) {
        return {nullptr, found.errors};
    }
    found.program->bindBlock("ViewBlock", binding::view);
    found.program->bindBlock("SceneBlock", binding::scene);
    found.program->bindBlock("ObjectBlock", binding::object);
    for (std::size_t i = 0; i < effects.textures.size(); ++i) {
        found.program->bindSampler(samplerName(i).c_str(),
                                   binding::firstTexture + static_cast<unsigned>(i));
    }
    found.program->bindSampler("shadowMaps", binding::shadowMaps);
    if (effects.scene.environment) {
        environment::assignUnits(*found.program);
    }
    pipeline->catalog = catalog_;
    pipeline->object = objectLayout(effects, *catalog_);
    pipeline->scene = sceneLayout(effects.scene, *catalog_);
    pipeline->effects = std::move(effects);
    pipeline->sceneKey = sceneKey;
    pipeline->program = found.program;
    return {std::move(pipeline), {}};
}

} // namespace patina
