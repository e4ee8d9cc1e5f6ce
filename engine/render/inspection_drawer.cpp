// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/inspection_drawer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include <epoxy/gl.h>
#include <glm/matrix.hpp>

#include "render/binding.h"
#include "render/data_packer.h"
#include "shading/effect_choice.h"
#include "shading/texture_choice.h"

namespace patina {
namespace {

/// Terms in one window, and the number of the first light's (shaders/passes/inspection.glsl).
constexpr int window = inspectionOutputs - 1;
constexpr int firstLightTerm = 7;

/// Beyond this a half float's whole range is black or white.
constexpr double mostStops = 40.0;

float luminance(const glm::dvec3& color) {
    const double sum = 0.2126 * color.r + 0.7152 * color.g + 0.0722 * color.b;
    return std::isfinite(sum) ? static_cast<float>(std::clamp(sum, 0.0, 65504.0)) : 0.0f;
}

void add(Errors& errors, const Errors& more) {
    for (const Error& error : more) {
        if (std::find(errors.begin(), errors.end(), error) == errors.end()) {
            errors.push_back(error);
        }
    }
}

/// The scene's lights in the order of the program's terms.
std::vector<std::size_t> lightsOf(const Scene& scene, const Pipeline& pipeline) {
    const bool shadows = hasShadows(scene, *pipeline.catalog);
    std::vector<std::size_t> order;
    for (const LightGroup& group : pipeline.effects.scene.lights) {
        for (std::size_t i = 0; i < scene.lights.size(); ++i) {
            if (EffectKey::ofLight(scene.lights[i], *pipeline.catalog, shadows) == group.key) {
                order.push_back(i);
            }
        }
    }
    return order;
}

} // namespace

InspectionDrawer::InspectionDrawer(std::filesystem::path programCache, GpuMeshStore& meshes,
                                   GpuTextureStore& textures, ShadowMaps& shadows)
    : pipelines_(programCache, SurfaceOutput::Inspection),
      tables_(std::move(programCache), SurfaceOutput::AlbedoTable), meshes_(meshes),
      textures_(textures), shadows_(shadows) {
    viewData_.reserve(ViewLayout::vec4s);
    sceneData_.reserve(static_cast<std::size_t>(pipelines_.sceneCapacity()));
}

void InspectionDrawer::setCatalog(std::shared_ptr<const Catalog> catalog) {
    catalog_ = std::move(catalog);
    pipelines_.setCatalog(catalog_);
    tables_.setCatalog(catalog_);
    display_.reset();
    for (Slot& slot : slots_) {
        slot.albedo.forget();
    }
}

Result<void> InspectionDrawer::drawLinear(const Scene& scene, const View& view,
                                          const MeshSource& meshes) {
    Result<void> ready = prepare(scene, view, meshes);
    if (ready) {
        ready = target_.fit(view.size, 1, false);
    }
    if (!ready) {
        report_.messages.assign(1, ready.error());
        return ready;
    }
    target_.bind();
    glClearColor(luminance(scene.background), 0.0f, 0.0f, 1.0f);
    glDepthMask(GL_TRUE);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    drawItems(scene, 0);
    target_.resolve();
    meshes_.endFrame();
    textures_.endFrame();
    return {};
}

Result<void> InspectionDrawer::prepare(const Scene& scene, const View& view,
                                       const MeshSource& meshes) {
    report_ = FrameReport();
    textures_.beginFrame();
    if (catalog_ == nullptr) {
        return failure("there are no shaders to draw with", "a call of setCatalog before draw");
    }
    if (!display_) {
        const std::array<std::string, 1> files{"passes/inspection.frag"};
        const auto source = passProgram(*catalog_, "passes/screen.vert", files);
        if (!source) {
            return tl::unexpected(source.error().front());
        }
        const ProgramCache::Found found = pipelines_.programs().get(*source);
        if (!found.program) {
            return tl::unexpected(found.errors.front());
        }
        display_ = found.program;
    }
    collect(scene, view, meshes);
    choosePipelines(scene);
    drawShadows(scene);
    feed(scene, view);
    return {};
}

void InspectionDrawer::collect(const Scene& scene, const View& view, const MeshSource& meshes) {
    const glm::dmat4 worldToCamera = viewMatrix(view.camera);
    cameraToWorld_ = glm::inverse(worldToCamera);
    depths_ = DepthRange();
    items_.clear();
    instances_.clear();
    meshes_.beginFrame();
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const Object& object = scene.objects[i];
        const bool drawn = object.visible && canBeSeen(object.material);
        const MeshView mesh = drawn ? meshes(object) : MeshView{};
        if (!mesh.indices.empty()) {
            const glm::dmat4 world = worldMatrix(object);
            depths_.add(mesh.bounds, worldToCamera * world);
            items_.push_back({i, &meshes_.get(mesh), mesh.bounds, world});
            instances_.add(instanceAt(world));
        }
    }
    instances_.upload();
    while (slots_.size() < scene.objects.size()) {
        slots_.emplace_back();
    }
}

void InspectionDrawer::note(const PipelineStore::Entry& entry) {
    add(report_.messages, entry.errors);
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

void InspectionDrawer::choosePipelines(const Scene& scene) {
    const int before = pipelines_.programs().compiledCount();
    const PipelineStore::Surroundings surroundings{scene, keys_.ofScene(scene, *catalog_)};
    for (const Item& item : items_) {
        const Material& material = scene.objects[item.index].material;
        const std::uint64_t key = EffectKey::ofMaterial(material, *catalog_);
        const PipelineStore::Entry& entry = pipelines_.get(material, key, surroundings);
        note(entry);
        slots_[item.index].pipeline =
            entry.pipeline ? entry.pipeline : pipelines_.standIn(surroundings).pipeline;
    }
    report_.compiled = pipelines_.programs().compiledCount() - before;
}

/// The same maps as the picture's; where they cannot be made everything is lit.
void InspectionDrawer::drawShadows(const Scene& scene) {
    shadows_.clearCasters();
    for (const Item& item : items_) {
        if (isCaster(scene.objects[item.index])) {
            shadows_.addCaster(*item.mesh, {item.bounds, item.world},
                               scene.objects[item.index].material);
        }
    }
    if (auto planned =
            shadows_.plan(scene, scene, cameraToWorld_, pipelines_.programs(), textures_);
        !planned) {
        report_.messages.push_back(planned.error());
    }
    report_.shadowMaps = shadows_.pending();
    while (shadows_.pending() > 0) {
        shadows_.drawSome(std::numeric_limits<int>::max(), textures_);
    }
}

void InspectionDrawer::feed(const Scene& scene, const View& view) {
    const double aspect = double(view.size.x) / double(view.size.y);
    const glm::dmat4 worldToClip =
        projection(view.camera, aspect, depths_) * glm::inverse(cameraToWorld_);
    packView(viewData_.staging(), worldToClip, eye(view.camera), 1.0);
    report_.uploadedBuffers += viewData_.upload(ViewLayout::vec4s) ? 1 : 0;
    viewData_.bind(binding::view);
    for (const Item& item : items_) {
        const Slot& slot = slots_[item.index];
        if (slot.pipeline) {
            // All were made for this scene: they read the same data.
            const PackedScene packed =
                packScene(sceneData_.staging(), *slot.pipeline, {scene, scene, shadows_.views()},
                          cameraToWorld_);
            report_.uploadedBuffers += sceneData_.upload(packed.vec4s) ? 1 : 0;
            break;
        }
    }
    for (const Item& item : items_) {
        if (slots_[item.index].pipeline) {
            feedMaterial(scene.objects[item.index].material, slots_[item.index]);
        }
    }
}

void InspectionDrawer::feedMaterial(const Material& material, Slot& slot) {
    const auto size = static_cast<std::size_t>(slot.pipeline->object.vec4s);
    slot.data.reserve(size);
    packMaterial(slot.data.staging(), *slot.pipeline, material, cameraToWorld_);
    textures_.bind(slot.data.staging(), *slot.pipeline, material);
    const bool changed = slot.data.upload(size);
    report_.uploadedBuffers += changed ? 1 : 0;
    if (!slot.pipeline->object.model) {
        return;
    }
    static const Scene nothing; // a table knows no lights
    const PipelineStore::Entry& table =
        tables_.get(material, EffectKey::ofMaterial(material, *catalog_), {nothing});
    if (table.pipeline && (changed || slot.albedo.filledWith() != table.pipeline.get())) {
        slot.data.bind(binding::object);
        slot.albedo.fill(*table.pipeline);
    }
}

/// The target is bound.
void InspectionDrawer::drawItems(const Scene& scene, int firstTerm) {
    glEnable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glDisable(GL_BLEND);
    glDisable(GL_DITHER);
    glDepthFunc(GL_LESS);
    sceneData_.bind(binding::scene);
    shadows_.bind();
    for (std::size_t i = 0; i < items_.size(); ++i) {
        const Item& item = items_[i];
        Slot& slot = slots_[item.index];
        if (slot.pipeline) {
            ++report_.drawnObjects;
            slot.data.bind(binding::object);
            slot.pipeline->program->use();
            glUniform1i(slot.pipeline->program->uniform("firstTerm"), firstTerm);
            glUniform1f(slot.pipeline->program->uniform("objectNumber"),
                        static_cast<float>(item.index + 1));
            slot.albedo.bind();
            textures_.bind(slot.data.staging(), *slot.pipeline,
                           scene.objects[item.index].material);
            item.mesh->draw(instances_, {0, item.mesh->triangles(), i, 1});
        }
    }
}

void InspectionDrawer::show(const Scene& scene, const View& view, unsigned framebuffer) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, view.size.x, view.size.y);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    display_->use();
    const double stops = std::clamp(scene.exposure, -mostStops, mostStops);
    glUniform1f(display_->uniform("exposureFactor"), static_cast<float>(std::exp2(stops)));
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, target_.resolved().name());
    noVertices_.bind();
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
    glUseProgram(0);
    glBindTexture(GL_TEXTURE_2D, 0);
}

Result<std::optional<PixelProbe>> InspectionDrawer::probe(const Scene& scene, const View& view,
                                                          const MeshSource& meshes,
                                                          glm::ivec2 pixel) {
    if (auto prepared = prepare(scene, view, meshes); !prepared) {
        return tl::unexpected(prepared.error());
    }
    if (!probeTarget_) {
        Result<ProbeTarget> target = ProbeTarget::create();
        if (!target) {
            return tl::unexpected(target.error());
        }
        probeTarget_ = std::move(*target);
    }
    const glm::ivec2 fromBelow(pixel.x, view.size.y - 1 - pixel.y);
    probeTarget_->begin(view.size, fromBelow);
    drawItems(scene, 0);
    const ProbeTarget::Outputs outputs = probeTarget_->read(fromBelow);
    const auto number = static_cast<std::size_t>(outputs[0].b);
    const auto item = std::find_if(items_.begin(), items_.end(), [number](const Item& each) {
        return each.index + 1 == number;
    });
    if (item == items_.end()) {
        return std::optional<PixelProbe>();
    }
    PixelProbe probe = read(scene, *item, outputs);
    readLights(scene, view, fromBelow, probe);
    glBindVertexArray(0);
    glUseProgram(0);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    return std::optional(std::move(probe));
}

PixelProbe InspectionDrawer::read(const Scene& scene, const Item& item,
                                  const ProbeTarget::Outputs& outputs) {
    const EffectSet& effects = slots_[item.index].pipeline->effects;
    const auto term = [&outputs](std::size_t i) { return outputs[i + 1]; };
    PixelProbe probe;
    probe.object = item.index;
    probe.defect = static_cast<PixelDefect>(std::clamp(std::lround(outputs[0].g), 0L, 4L));
    probe.normal = glm::vec3(term(0));
    probe.nv = term(0).w;
    probe.albedo = term(1).w > 0.0f ? std::optional(glm::vec3(term(1))) : std::nullopt;
    if (effects.model && (effects.scene.ambient || effects.scene.hemisphere)) {
        probe.ambient = glm::vec3(term(2));
    }
    if (!effects.emission.empty()) {
        probe.emission = glm::vec3(term(3));
    }
    if (effects.blend) {
        probe.blended = BlendedColor{glm::vec3(term(4)), term(4).w};
    }
    if (effects.scene.fog) {
        probe.fogged = BlendedColor{glm::vec3(term(5)), term(5).w};
    }
    probe.color = glm::vec3(term(6));
    probe.opacity = term(6).w;
    for (const std::size_t light : lightsOf(scene, *slots_[item.index].pipeline)) {
        probe.lights.push_back({light, {}, 0.0f});
    }
    if (!effects.model) {
        probe.lights.clear();
    }
    return probe;
}

void InspectionDrawer::readLights(const Scene& scene, const View& view, glm::ivec2 pixel,
                                  PixelProbe& probe) {
    for (std::size_t first = 0; first < probe.lights.size(); first += window) {
        probeTarget_->begin(view.size, pixel);
        drawItems(scene, firstLightTerm + static_cast<int>(first));
        const ProbeTarget::Outputs outputs = probeTarget_->read(pixel);
        const std::size_t count = std::min<std::size_t>(window, probe.lights.size() - first);
        for (std::size_t i = 0; i < count; ++i) {
            probe.lights[first + i].value = glm::vec3(outputs[i + 1]);
            probe.lights[first + i].nl = outputs[i + 1].w;
        }
    }
}

} // namespace patina
