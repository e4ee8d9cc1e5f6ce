// SPDX-License-Identifier: GPL-3.0-or-later
#include "assembled_program.h"

#include <cstdlib>

#include <fmt/format.h>
#include <glm/matrix.hpp>

#include "render/gpu/binding.h"
#include "render/pass/data_packer.h"
#include "shading/effects/effect_key.h"

namespace patina::benchmarks {

AssembledProgram::AssembledProgram(const std::shared_ptr<const Catalog>& catalog,
                                   const Scene& scene, const BallStage& stage) {
    PipelineStore store({});
    store.setCatalog(catalog);
    const Material& material = scene.objects.front().material;
    const PipelineStore::Entry& entry =
        store.get(material, EffectKey::ofMaterial(material, *catalog),
                  {scene, EffectKey().ofScene(scene, *catalog)});
    if (!entry.pipeline) {
        fmt::print(stderr, "{}\n", text(entry.errors));
        std::exit(2);
    }
    pipeline_ = entry.pipeline;
    const glm::dmat4 cameraToWorld = glm::inverse(viewMatrix(stage.camera()));
    const auto capacity = static_cast<std::size_t>(store.sceneCapacity());
    const auto object = static_cast<std::size_t>(pipeline_->object.vec4s);
    view_.reserve(ViewLayout::vec4s);
    scene_.reserve(capacity);
    object_.reserve(object);
    packView(view_.staging(), stage.worldToClip(), eye(stage.camera()), 1.0);
    const std::vector<ShadowView> shadows{
        stage.pictures().shadowView(*catalog, scene.lights.front(), cameraToWorld)};
    packScene(scene_.staging(), *pipeline_, {scene, scene, shadows}, cameraToWorld);
    packMaterial(object_.staging(), *pipeline_, material, cameraToWorld);
    view_.upload(ViewLayout::vec4s);
    scene_.upload(capacity);
    object_.upload(object);
}

void AssembledProgram::use() {
    view_.bind(binding::view);
    scene_.bind(binding::scene);
    object_.bind(binding::object);
    pipeline_->program->use();
}

} // namespace patina::benchmarks
