// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/surfaces/inspection_drawer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include <epoxy/gl.h>

#include "core/color.h"
#include "core/exposure.h"
#include "render/gpu/binding.h"
#include "render/gpu/capture_image.h"
#include "shading/program/storable.h"

namespace patina {
namespace {

/// `window` is how many terms one drawing writes; `firstLightTerm` is the number of the first
/// light's term (shaders/passes/inspection.glsl).
constexpr int window = inspectionOutputs - 1;
constexpr int firstLightTerm = 7;

/// Returns the place of a light of the scene in the order of a program; -1 where it is not there.
int placeOfLight(const Scene& scene, const Pipeline& pipeline, std::size_t light) {
    const std::vector<std::size_t> order = lightsInOrder(scene, pipeline);
    const auto found = std::ranges::find(order, light);
    return found == order.end() ? -1 : static_cast<int>(found - order.begin());
}

} // namespace

InspectionDrawer::InspectionDrawer(RenderResources& shared)
    : shared_(shared), items_(shared, SurfaceOutput::Inspection),
      tables_(shared.programCache, SurfaceOutput::AlbedoTable) {}

void InspectionDrawer::followCatalog() {
    if (catalog_ == shared_.catalog) {
        return;
    }
    catalog_ = shared_.catalog;
    items_.setCatalog(catalog_);
    tables_.setCatalog(catalog_);
    display_.reset();
    viewDisplay_.reset();
    for (AlbedoTable& albedo : albedos_) {
        albedo.forget();
    }
}

const FrameReport& InspectionDrawer::draw(const Scene& scene, const View& view,
                                          const MeshSource& meshes, unsigned framebuffer,
                                          const Inspected& shown) {
    if (drawLinear(scene, view, meshes, shown)) {
        show(scene, view, framebuffer, shown);
    }
    return report();
}

Result<Image> InspectionDrawer::capture(const Scene& scene, const View& view,
                                        const MeshSource& meshes, bool display,
                                        const Inspected& shown) {
    if (auto drawn = drawLinear(scene, view, meshes, shown); !drawn) {
        return tl::unexpected(drawn.error());
    }
    if (!display) {
        return readLinear(target_.resolvedFramebuffer(), view.size, 0.0);
    }
    return readDisplay(view.size, [&](unsigned target) { show(scene, view, target, shown); });
}

/// Draws into the linear target: of the numbers luminance in red and PixelDefect in green.
Result<void> InspectionDrawer::drawLinear(const Scene& scene, const View& view,
                                          const MeshSource& meshes, const Inspected& shown) {
    Result<void> ready = prepare(scene, view, meshes);
    if (ready) {
        ready = target_.fit(view.size, 1, false).map([](bool) {});
    }
    if (!ready) {
        items_.report().messages.assign(1, ready.error());
        return ready;
    }
    target_.bind();
    if (shown.view == InspectedView::Numbers) {
        glClearColor(storable(luminance(scene.background)), 0.0f, 0.0f, 1.0f);
    } else {
        glClearColor(0.0f, 0.0f, 0.0f, 0.0f); // there is no surface
    }
    glDepthMask(GL_TRUE);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    drawItems(scene, 0, shown);
    target_.resolve();
    items_.end();
    return {};
}

Result<void> InspectionDrawer::makeDisplays() {
    if (display_ && viewDisplay_) {
        return {};
    }
    for (const auto& [made, file] : {std::pair{&display_, "passes/inspection.frag"},
                                     std::pair{&viewDisplay_, "passes/inspected_view.frag"}}) {
        const std::array<std::string, 1> files{file};
        const auto source = passProgram(*catalog_, "passes/screen.vert", files);
        if (!source) {
            return tl::unexpected(source.error().front());
        }
        const ProgramCache::Found found = items_.pipelines().programs().get(*source);
        if (!found.program) {
            return tl::unexpected(found.errors.front());
        }
        *made = found.program;
    }
    return {};
}

Result<void> InspectionDrawer::prepare(const Scene& scene, const View& view,
                                       const MeshSource& meshes) {
    items_.report() = FrameReport();
    followCatalog();
    if (catalog_ == nullptr) {
        return failure("there are no shaders to draw with", "a call of setCatalog before draw");
    }
    if (Result<void> made = makeDisplays(); !made) {
        return made;
    }
    items_.prepare(scene, view, meshes, false);
    while (albedos_.size() < scene.objects.size()) {
        albedos_.emplace_back();
    }
    for (const Item& item : items_.items()) {
        if (item.pipeline && item.pipeline->object.model) {
            fillAlbedo(scene.objects[item.index].material, item);
        }
    }
    return {};
}

void InspectionDrawer::fillAlbedo(const Material& material, const Item& item) {
    static const Scene nothing; // has no lights, which a table does not depend on
    const PipelineStore::Entry& table =
        tables_.get(material, EffectKey::ofMaterial(material, *catalog_), {nothing});
    AlbedoTable& albedo = albedos_[item.index];
    if (table.pipeline && (item.isNew || albedo.filledWith() != table.pipeline.get())) {
        item.data->bind(binding::object);
        items_.bindMeasured(material, item);
        albedo.fill(*table.pipeline);
    }
}

/// Draws all items into the target that is bound. The terms from number `firstTerm` on are written.
void InspectionDrawer::drawItems(const Scene& scene, int firstTerm, const Inspected& shown) {
    items_.draw(scene, [&](const Item& item) {
        glUniform1i(item.pipeline->program->uniform("shown"), static_cast<int>(shown.view));
        if (shown.view == InspectedView::Light) {
            glUniform1i(item.pipeline->program->uniform("shownLight"),
                        placeOfLight(scene, *item.pipeline, shown.light));
        }
        glUniform1i(item.pipeline->program->uniform("firstTerm"), firstTerm);
        glUniform1f(item.pipeline->program->uniform("objectNumber"),
                    static_cast<float>(item.index + 1));
        albedos_[item.index].bind();
    });
}

/// Draws the linear target into a framebuffer, with patterns for defects.
void InspectionDrawer::show(const Scene& scene, const View& view, unsigned framebuffer,
                            const Inspected& shown) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, view.size.x, view.size.y);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    const gl::Program& display = shown.view == InspectedView::Numbers ? *display_ : *viewDisplay_;
    display.use();
    if (shown.view != InspectedView::Numbers) {
        glUniform1i(display.uniform("shown"), static_cast<int>(shown.view));
    }
    glUniform1f(display.uniform("exposureFactor"),
                static_cast<float>(exposureFactor(scene.exposure)));
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
    const auto item = std::ranges::find_if(
        items_.items(), [number](const Item& each) { return each.index + 1 == number; });
    if (item == items_.items().end()) {
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
    const EffectSet& effects = item.pipeline->effects;
    const auto term = [&outputs](std::size_t i) { return outputs[i + 1]; };
    PixelProbe probe;
    probe.object = item.index;
    probe.defect = static_cast<PixelDefect>(std::clamp(std::lround(outputs[0].g), 0L, 4L));
    probe.normal = glm::vec3(term(0));
    probe.nv = term(0).w;
    probe.albedo = term(1).w > 0.0f ? std::optional(glm::vec3(term(1))) : std::nullopt;
    if (effects.model && (effects.ambient || effects.hemisphere) && takesAmbient(effects)) {
        probe.ambient = glm::vec3(term(2));
    }
    if (!effects.emission.empty()) {
        probe.emission = glm::vec3(term(3));
    }
    if (effects.blend) {
        probe.blended = BlendedColor{glm::vec3(term(4)), term(4).w};
    }
    if (effects.fog) {
        probe.fogged = BlendedColor{glm::vec3(term(5)), term(5).w};
    }
    probe.color = glm::vec3(term(6));
    probe.opacity = term(6).w;
    for (const std::size_t light : lightsInOrder(scene, *item.pipeline)) {
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
