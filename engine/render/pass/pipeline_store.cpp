// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/pass/pipeline_store.h"

#include <algorithm>

#include <glm/vec4.hpp>

#include "gl/driver.h"
#include "render/gpu/binding.h"
#include "render/gpu/environment_units.h"
#include "render/pass/refraction_targets.h"
#include "shading/effects/effect_set.h"
#include "shading/effects/surface_program.h"
#include "shading/effects/texture_writer.h"

namespace patina {
namespace {

/// Assigns the blocks and images that a program of surfaces reads.
void bindSurface(const gl::Program& program, const EffectSet& effects) {
    program.bindBlock("ViewBlock", binding::view);
    program.bindBlock("SceneBlock", binding::scene);
    program.bindBlock("ObjectBlock", binding::object);
    for (std::size_t i = 0; i < effects.textures.size(); ++i) {
        program.bindSampler(samplerName(i).c_str(),
                            binding::firstTexture + static_cast<unsigned>(i));
    }
    program.bindSampler("shadowMaps", binding::shadowMaps);
    RefractionTargets::assignUnits(program);
    if (effects.environment) {
        environment::assignUnits(program);
    }
    program.bindSampler("blockTables", binding::blockTables);
    program.bindSampler("measuredTable", binding::measuredTable);
}

} // namespace

PipelineStore::PipelineStore(std::filesystem::path programCache, SurfaceOutput output)
    : programs_(std::move(programCache)), output_(output),
      sceneCapacity_(std::clamp(gl::largestUniformBlock() / int(sizeof(glm::vec4)),
                                SceneLayout::minCapacity, SceneLayout::maxCapacity)) {}

void PipelineStore::setCatalog(std::shared_ptr<const Catalog> catalog) {
    catalog_ = std::move(catalog);
    entries_.clear();
}

const PipelineStore::Entry& PipelineStore::get(const Material& material, std::uint64_t materialKey,
                                               const Surroundings& surroundings) {
    return find(materialKey, material, surroundings);
}

const PipelineStore::Entry& PipelineStore::fallback(const Surroundings& surroundings) {
    static const Material nothing;
    return find(0, nothing, surroundings);
}

const PipelineStore::Entry& PipelineStore::ground(const Surroundings& around) {
    const Key key{keyOf(around.scene.ground.mode), around.key};
    if (!hasFinal(key)) {
        EffectSet effects = groundEffects(around.scene, *catalog_, around.view);
        entries_.insert_or_assign(key, make(std::move(effects), around.key));
    }
    return entries_.at(key);
}

bool PipelineStore::hasFinal(const Key& key) const {
    const auto known = entries_.find(key);
    return known != entries_.end() && known->second.isFinal;
}

const PipelineStore::Entry& PipelineStore::find(std::uint64_t materialKey, const Material& material,
                                                const Surroundings& surroundings) {
    const Key key{materialKey, surroundings.key};
    if (!hasFinal(key)) {
        EffectSet effects = effectSet(material, surroundings.scene, *catalog_, surroundings.view);
        entries_.insert_or_assign(key, make(std::move(effects), key.second));
    }
    return entries_.at(key);
}

tl::expected<void, PipelineStore::Entry> PipelineStore::addOutline(Pipeline& pipeline,
                                                                   const EffectSet& effects) {
    const auto source = outlineProgram(effects, *catalog_, sceneCapacity_);
    if (!source) {
        return tl::unexpected(Entry{nullptr, source.error()});
    }
    const ProgramCache::Found found = programs_.get(*source);
    if (!found.program) {
        return tl::unexpected(Entry{nullptr, found.errors, found.isFinal});
    }
    found.program->bindBlock("ViewBlock", binding::view);
    found.program->bindBlock("SceneBlock", binding::scene);
    found.program->bindBlock("ObjectBlock", binding::object);
    pipeline.outline = outlineLayout(effects);
    pipeline.outlineProgram = found.program;
    return {};
}

tl::expected<void, PipelineStore::Entry> PipelineStore::addFins(Pipeline& pipeline,
                                                                const EffectSet& effects) {
    const auto source = finsProgram(effects, *catalog_, sceneCapacity_);
    if (!source) {
        return tl::unexpected(Entry{nullptr, source.error()});
    }
    const ProgramCache::Found found = programs_.get(*source);
    if (!found.program) {
        return tl::unexpected(Entry{nullptr, found.errors, found.isFinal});
    }
    bindSurface(*found.program, effects);
    pipeline.finsProgram = found.program;
    return {};
}

tl::expected<void, PipelineStore::Entry> PipelineStore::addMarks(Pipeline& pipeline,
                                                                 const EffectSet& effects) {
    const auto source = marksProgram(effects, *catalog_, sceneCapacity_);
    if (!source) {
        return tl::unexpected(Entry{nullptr, source.error()});
    }
    const ProgramCache::Found found = programs_.get(*source);
    if (!found.program) {
        return tl::unexpected(Entry{nullptr, found.errors, found.isFinal});
    }
    bindSurface(*found.program, effects);
    pipeline.marksProgram = found.program;
    return {};
}

/// Adds the program that fills tables together with the one that reads them, so that filling them
/// later compiles nothing.
tl::expected<void, PipelineStore::Entry> PipelineStore::addTables(Pipeline& pipeline,
                                                                  const EffectSet& effects) {
    const auto source = surfaceProgram(effects, *catalog_, SurfaceOutput::Tables);
    if (!source) {
        return tl::unexpected(Entry{nullptr, source.error()});
    }
    const ProgramCache::Found found = programs_.get(*source);
    if (!found.program) {
        return tl::unexpected(Entry{nullptr, found.errors, found.isFinal});
    }
    found.program->bindBlock("ObjectBlock", binding::object);
    pipeline.tableProgram = found.program;
    return {};
}

/// Adds the programs that fit lobes together with the one that reads them, so that fitting them
/// later compiles nothing.
tl::expected<void, PipelineStore::Entry> PipelineStore::addLobes(Pipeline& pipeline,
                                                                 const EffectSet& effects) {
    const LobeTableShape shape = lobeTableShape(effects.model->block());
    const auto samples = surfaceProgram(effects, *catalog_, SurfaceOutput::LobeSamples);
    const auto fit = lobeFitProgram(shape, *catalog_);
    const auto table = lobeTableProgram(shape, *catalog_);
    for (const auto& [source, made] :
         {std::pair(&samples, &pipeline.lobeSamples), std::pair(&fit, &pipeline.lobeFit),
          std::pair(&table, &pipeline.lobeTable)}) {
        if (!*source) {
            return tl::unexpected(Entry{nullptr, source->error()});
        }
        const ProgramCache::Found found = programs_.get(**source);
        if (!found.program) {
            return tl::unexpected(Entry{nullptr, found.errors, found.isFinal});
        }
        *made = found.program;
    }
    pipeline.lobeSamples->bindBlock("ObjectBlock", binding::object);
    pipeline.lobeSamples->bindSampler("measuredTable", binding::measuredTable);
    pipeline.lobeFit->bindSampler("lobeSamples", 0);
    pipeline.lobeTable->bindSampler("fittedLobes", 0);
    return {};
}

PipelineStore::Entry PipelineStore::make(EffectSet effects, std::uint64_t sceneKey) {
    auto pipeline = std::make_shared<Pipeline>();
    const auto source = surfaceProgram(effects, *catalog_, output_, sceneCapacity_);
    if (!source) {
        return {nullptr, source.error()};
    }
    const ProgramCache::Found found = programs_.get(*source);
    if (!found.program) {
        return {nullptr, found.errors, found.isFinal};
    }
    bindSurface(*found.program, effects);
    pipeline->object = objectLayout(effects);
    if (!pipeline->object.tables.empty() && output_ == SurfaceOutput::Picture) {
        if (auto added = addTables(*pipeline, effects); !added) {
            return added.error();
        }
    }
    if (effects.method == EnvironmentMethod::Fitted && output_ == SurfaceOutput::Picture) {
        if (auto added = addLobes(*pipeline, effects); !added) {
            return added.error();
        }
    }
    if (effects.outline && output_ == SurfaceOutput::Picture) {
        if (auto added = addOutline(*pipeline, effects); !added) {
            return added.error();
        }
    }
    if (effects.shells && hasFins(*effects.shells) && output_ == SurfaceOutput::Picture) {
        if (auto added = addFins(*pipeline, effects); !added) {
            return added.error();
        }
    }
    if (effects.strokes && output_ == SurfaceOutput::Picture) {
        if (auto added = addMarks(*pipeline, effects); !added) {
            return added.error();
        }
    }
    pipeline->catalog = catalog_;
    pipeline->scene = sceneLayout(effects);
    pipeline->effects = std::move(effects);
    pipeline->sceneKey = sceneKey;
    pipeline->program = found.program;
    return {std::move(pipeline), {}};
}

} // namespace patina
