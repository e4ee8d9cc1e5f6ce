// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/surfaces/surface_items.h"

#include <algorithm>
#include <limits>

#include <epoxy/gl.h>
#include <glm/matrix.hpp>

#include "render/gpu/binding.h"
#include "render/pass/data_packer.h"
#include "shading/effects/effect_set.h"
#include "shading/effects/key_light.h"

namespace patina {
std::vector<std::size_t> lightsInOrder(const Scene& scene, const Pipeline& pipeline) {
    const bool shadows = hasShadows(scene, *pipeline.catalog);
    std::vector<std::size_t> order;
    const bool takesOne = takesKeyAlone(pipeline.effects);
    const std::optional<std::size_t> taken = keyLight(scene, *pipeline.catalog);
    for (const LightGroup& group : pipeline.effects.lights) {
        const std::uint64_t key = group.key();
        for (std::size_t i = 0; i < scene.lights.size(); ++i) {
            if ((!takesOne || i == taken) &&
                EffectKey::ofLight(scene.lights[i], *pipeline.catalog, shadows) == key) {
                order.push_back(i);
            }
        }
    }
    return order;
}

SurfaceItems::SurfaceItems(RenderResources& shared, SurfaceOutput output)
    : pipelines_(shared.programCache, output), shared_(shared), textures_{shared.textures},
      shadows_(shared.shadows) {
    viewData_.reserve(ViewLayout::vec4s);
    sceneData_.reserve(static_cast<std::size_t>(pipelines_.sceneCapacity()));
}

void SurfaceItems::setCatalog(std::shared_ptr<const Catalog> catalog) {
    catalog_ = std::move(catalog);
    pipelines_.setCatalog(catalog_);
    shadows_.setCatalog(catalog_);
}

void SurfaceItems::prepare(const Scene& scene, const View& view, const MeshSource& meshes,
                           bool usesDepths) {
    report_ = FrameReport();
    textures_.begin();
    collect(scene, view, meshes);
    choosePipelines(scene, usesDepths ? effectView(depths_, fogReach(scene)) : EffectView());
    drawShadows(scene);
    feed(scene, view);
}

FogReach SurfaceItems::fogReach(const Scene& scene) const {
    FogReach fog(scene, *catalog_, glm::dvec3(around_.cameraToWorld[3]));
    for (const Item& item : items_) {
        fog.add(item.bounds, item.world);
    }
    return fog;
}

void SurfaceItems::end() {
    shadows_.giveBack();
    shared_.meshes.endFrame();
    shared_.textures.endFrame();
}

void SurfaceItems::collect(const Scene& scene, const View& view, const MeshSource& meshes) {
    const glm::dmat4 worldToCamera = viewMatrix(view.camera);
    around_ = {glm::inverse(worldToCamera), scene.wavelengths, view.pixelRatio};
    depths_ = DepthRange();
    items_.clear();
    instances_.clear();
    shared_.meshes.beginFrame();
    while (data_.size() < scene.objects.size()) {
        data_.push_back(std::make_unique<UniformBuffer>());
    }
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const Object& object = scene.objects[i];
        const bool drawn = object.visible && canBeSeen(object.material);
        const MeshView mesh = drawn ? meshes(object) : MeshView{};
        if (!mesh.indices.empty()) {
            const glm::dmat4 world = worldMatrix(object);
            depths_.add(mesh.bounds, worldToCamera * world);
            items_.push_back(
                {i, &shared_.meshes.get(mesh), mesh.bounds, world, data_[i].get(), {}});
            instances_.add(instanceAt(world));
        }
    }
    instances_.upload();
}

void SurfaceItems::note(const PipelineStore::Entry& entry) {
    addNew(report_.messages, entry.errors);
    if (!entry.pipeline) {
        return;
    }
    for (const EffectLine& line : effectLines(entry.pipeline->effects)) {
        if (std::find(report_.effects.begin(), report_.effects.end(), line.effect) ==
            report_.effects.end()) {
            report_.effects.push_back(line.effect);
        }
    }
}

void SurfaceItems::choosePipelines(const Scene& scene, const EffectView& view) {
    const int before = pipelines_.programs().compiledCount();
    const PipelineStore::Surroundings around{scene, keys_.ofScene(scene, *catalog_, view), view};
    for (Item& item : items_) {
        const Material& material = scene.objects[item.index].material;
        const std::uint64_t key = EffectKey::ofMaterial(material, *catalog_);
        const PipelineStore::Entry& entry = pipelines_.get(material, key, around);
        note(entry);
        item.pipeline = entry.pipeline ? entry.pipeline : pipelines_.fallback(around).pipeline;
    }
    report_.compiled = pipelines_.programs().compiledCount() - before;
}

/// Draws the shadow maps, which are those of the picture; where they cannot be made, everything is
/// lit.
void SurfaceItems::drawShadows(const Scene& scene) {
    shadows_.begin();
    for (const Item& item : items_) {
        if (isCaster(scene.objects[item.index], *catalog_)) {
            shadows_.addCaster(*item.mesh, {item.bounds, item.world},
                               scene.objects[item.index].material);
        }
    }
    ProgramCache& programs = pipelines_.programs();
    const auto planned =
        shadows_.plan(scene, scene, around_.cameraToWorld, programs, shared_.textures);
    const auto held = planned ? shadows_.hold(true, programs) : tl::unexpected(planned.error());
    if (!held) {
        report_.messages.push_back(held.error());
    }
    report_.shadowMaps = shadows_.pending();
    while (shadows_.pending() > 0) {
        shadows_.drawSome(std::numeric_limits<int>::max(), textures_);
    }
}

void SurfaceItems::feed(const Scene& scene, const View& view) {
    const double aspect = double(view.size.x) / double(view.size.y);
    const glm::dmat4 worldToClip =
        projection(view.camera, aspect, depths_) * glm::inverse(around_.cameraToWorld);
    packView(viewData_.staging(), worldToClip, eye(view.camera), 1.0);
    report_.uploadedBuffers += viewData_.upload(ViewLayout::vec4s) ? 1 : 0;
    viewData_.bind(binding::view);
    // All were made for this scene: they read the same data.
    const auto fed =
        std::ranges::find_if(items_, [](const Item& item) { return item.pipeline != nullptr; });
    if (fed != items_.end()) {
        const PackedScene packed =
            packScene(sceneData_.staging(), *fed->pipeline, {scene, scene, shadows_.views()},
                      around_.cameraToWorld);
        report_.uploadedBuffers += sceneData_.upload(packed.vec4s) ? 1 : 0;
    }
    for (Item& item : items_) {
        if (item.pipeline) {
            feedMaterial(scene.objects[item.index].material, item);
        }
    }
}

void SurfaceItems::feedMaterial(const Material& material, Item& item) {
    const auto size = static_cast<std::size_t>(item.pipeline->object.vec4s);
    item.data->reserve(size);
    packMaterial(item.data->staging(), *item.pipeline, material, around_);
    bindImages(material, item);
    item.isNew = item.data->upload(size);
    report_.uploadedBuffers += item.isNew ? 1 : 0;
}

/// Binds the images of a material and the table of its measured file.
void SurfaceItems::bindImages(const Material& material, const Item& item) {
    textures_.bind(item.data->staging(), *item.pipeline, material);
    bindMeasured(material, item);
}

void SurfaceItems::bindMeasured(const Material& material, const Item& item) {
    if (item.pipeline->effects.model) {
        shared_.measured.bind(item.pipeline->effects.model->block(), material.model.parameters);
    }
}

void SurfaceItems::draw(const Scene& scene, const std::function<void(const Item&)>& begin) {
    glEnable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glDisable(GL_BLEND);
    glDisable(GL_DITHER);
    glDepthFunc(GL_LESS);
    sceneData_.bind(binding::scene);
    shadows_.bind();
    for (std::size_t i = 0; i < items_.size(); ++i) {
        const Item& item = items_[i];
        if (!item.pipeline) {
            continue;
        }
        ++report_.drawnObjects;
        item.data->bind(binding::object);
        item.pipeline->program->use();
        begin(item);
        bindImages(scene.objects[item.index].material, item);
        item.mesh->draw(instances_, {0, item.mesh->triangles(), i, 1});
    }
}

} // namespace patina
