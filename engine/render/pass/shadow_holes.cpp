// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/pass/shadow_holes.h"

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

std::size_t ShadowHoles::add(const Material& material, double opacity) {
    if (holes_.size() == count_) {
        holes_.emplace_back();
        hasChanged_ = true;
    }
    Holes& holes = holes_[count_];
    const TextureUse& use = material.textures.find(opacityId)->second;
    const auto known = holes.material.textures.find(opacityId);
    const bool isSame = known != holes.material.textures.end() && known->second == use &&
                        holes.material.opacity == opacity;
    if (!isSame) {
        holes.material.opacity = opacity;
        holes.material.textures.insert_or_assign(opacityId, use);
        holes.pipeline.reset();
        hasChanged_ = true;
    }
    return count_++;
}

Result<void> ShadowHoles::prepare(const std::shared_ptr<const Catalog>& catalog,
                                  ProgramCache& programs, const GpuTextureStore& textures) {
    for (std::size_t i = 0; i < count_; ++i) {
        Holes& holes = holes_[i];
        if (!holes.pipeline || holes.pipeline->catalog != catalog) {
            auto made = pipelineFor(holes.material, catalog, programs);
            if (!made) {
                return tl::unexpected(made.error());
            }
            holes.pipeline = std::move(*made);
        }
        const std::uint64_t state =
            textures.stateOf(holes.pipeline->effects.textures.front(), holes.material);
        hasChanged_ = hasChanged_ || state != holes.state;
        holes.state = state;
    }
    return {};
}

Result<std::shared_ptr<const Pipeline>>
ShadowHoles::pipelineFor(const Material& material, const std::shared_ptr<const Catalog>& catalog,
                         ProgramCache& programs) {
    OpacityPart part = *holesOf(material, *catalog);
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

void ShadowHoles::use(std::size_t number, const glm::mat4& worldToMap, FrameTextures& textures) {
    const Holes& holes = holes_[number];
    const Pipeline& pipeline = *holes.pipeline;
    const auto vec4s = static_cast<std::size_t>(pipeline.object.vec4s);
    data_.reserve(vec4s);
    packMaterial(data_.staging(), pipeline, holes.material, glm::dmat4(1.0));
    textures.bind(data_.staging(), pipeline, holes.material);
    data_.upload(vec4s);
    data_.bind(binding::object);
    pipeline.program->use();
    glUniformMatrix4fv(pipeline.program->uniform("worldToMap"), 1, GL_FALSE,
                       glm::value_ptr(worldToMap));
}

} // namespace patina
