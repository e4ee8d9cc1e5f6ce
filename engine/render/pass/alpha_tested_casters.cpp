// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/pass/alpha_tested_casters.h"

#include <epoxy/gl.h>
#include <glm/gtc/type_ptr.hpp>

#include "render/gpu/binding.h"
#include "render/pass/data_packer.h"
#include "shading/effects/shadow_source.h"
#include "shading/effects/texture_writer.h"

namespace patina {
namespace {

constexpr const char* opacityId = "opacity";

} // namespace

std::size_t AlphaTestedCasters::add(const Material& material, double opacity) {
    const std::size_t number = tests_.size();
    if (casters_.size() == number) {
        casters_.emplace_back();
    }
    Caster& caster = casters_[number];
    const TextureUse& use = material.textures.find(opacityId)->second;
    const auto known = caster.material.textures.find(opacityId);
    const bool isSame = known != caster.material.textures.end() && known->second == use &&
                        caster.material.opacity == opacity;
    if (!isSame) {
        caster.material.opacity = opacity;
        caster.material.textures.insert_or_assign(opacityId, use);
        caster.pipeline.reset();
    }
    tests_.push_back({opacity, use});
    return number;
}

Result<void> AlphaTestedCasters::prepare(const std::shared_ptr<const Catalog>& catalog,
                                         ProgramCache& programs, const GpuTextureStore& textures) {
    for (std::size_t i = 0; i < tests_.size(); ++i) {
        Caster& caster = casters_[i];
        if (!caster.pipeline || caster.pipeline->catalog != catalog) {
            auto made = pipelineFor(caster.material, catalog, programs);
            if (!made) {
                return tl::unexpected(made.error());
            }
            caster.pipeline = std::move(*made);
        }
        tests_[i].state =
            textures.stateOf(caster.pipeline->effects.textures.front(), caster.material);
    }
    return {};
}

Result<std::shared_ptr<const Pipeline>>
AlphaTestedCasters::pipelineFor(const Material& material,
                                const std::shared_ptr<const Catalog>& catalog,
                                ProgramCache& programs) {
    OpacityPart part = *alphaTestOf(material, *catalog);
    const BoundTexture& image = part.set.textures.front();
    std::shared_ptr<const Pipeline>& known = pipelines_[{image.channel, image.mode, image.cutOut}];
    if (known && known->catalog == catalog) {
        return known;
    }
    const auto source = shadowMapProgram(part, *catalog);
    if (!source) {
        return tl::unexpected(source.error().front());
    }
    const ProgramCache::Found found = programs.get(*source);
    if (!found.program) {
        return tl::unexpected(found.errors.front());
    }
    found.program->bindBlock("ObjectBlock", binding::object);
    found.program->bindSampler(samplerName(0).c_str(), binding::firstTexture);
    auto pipeline = std::make_shared<Pipeline>();
    pipeline->catalog = catalog;
    pipeline->effects = std::move(part.set);
    pipeline->object = std::move(part.layout);
    pipeline->program = found.program;
    known = std::move(pipeline);
    return known;
}

void AlphaTestedCasters::use(std::size_t number, const glm::mat4& worldToMap,
                             FrameTextures& textures) {
    const Caster& caster = casters_[number];
    const Pipeline& pipeline = *caster.pipeline;
    const auto vec4s = static_cast<std::size_t>(pipeline.object.vec4s);
    data_.reserve(vec4s);
    packMaterial(data_.staging(), pipeline, caster.material, glm::dmat4(1.0));
    textures.bind(data_.staging(), pipeline, caster.material);
    data_.upload(vec4s);
    data_.bind(binding::object);
    pipeline.program->use();
    glUniformMatrix4fv(pipeline.program->uniform("worldToMap"), 1, GL_FALSE,
                       glm::value_ptr(worldToMap));
}

} // namespace patina
