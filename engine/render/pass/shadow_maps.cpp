// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/pass/shadow_maps.h"

#include <algorithm>
#include <numeric>

#include <epoxy/gl.h>
#include <glm/gtc/type_ptr.hpp>

#include "render/gpu/binding.h"
#include "shading/effects/lights.h"
#include "shading/effects/opacity.h"
#include "shading/effects/shadow_source.h"
#include "shading/effects/shadows.h"

namespace patina {
namespace {

constexpr int minTexels = 256;
constexpr std::int64_t maxBytes = std::int64_t(256) << 20;

int maxLayers() {
    GLint most = 0;
    glGetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &most);
    return std::min(most, static_cast<int>(maxBytes / (std::int64_t(4) * minTexels * minTexels)));
}

const Block* shadowedLight(const Light& light, const Catalog& catalog) {
    const Block* block = catalog.find(kinds::lights, light.block.id);
    const bool shines = block != nullptr && canShine(light, *block);
    return shines && shadowBlock(light, *block, catalog) != nullptr ? block : nullptr;
}

} // namespace

void ShadowMaps::setCatalog(std::shared_ptr<const Catalog> catalog) {
    catalog_ = std::move(catalog);
    program_.reset();
    holes_.forget();
    layers_.clear();
}

void ShadowMaps::clearCasters() {
    meshes_.clear();
    byMesh_.clear();
    boxes_.clear();
    serials_.clear();
    holesOf_.clear();
    holes_.clear();
    views_.clear();
}

void ShadowMaps::addCaster(const GpuMesh& mesh, const CasterBox& box, const Material& material) {
    meshes_.push_back(&mesh);
    boxes_.push_back(box);
    serials_.push_back(mesh.serial());
    holesOf_.push_back(hasHoles(material) ? holes_.add(material, opacityOf(material, *catalog_))
                                          : solid);
}

Result<void> ShadowMaps::plan(const Scene& scene, const Scene& effects,
                              const glm::dmat4& cameraToWorld, ProgramCache& programs,
                              const GpuTextureStore& textures) {
    ++planNumber_;
    layer_ = 0;
    isBegun_ = false;
    lost_ = 0;
    hasNewImages_ = false;
    makeViews(scene, effects, cameraToWorld, maxTexels_);
    if (neededLayers() == 0) {
        layers_.clear();
        texture_ = gl::TextureArray();
        return {};
    }
    placeLayers(maxLayers());
    const int texels = texelsFor(neededLayers());
    if (texels != maxTexels_) {
        makeViews(scene, effects, cameraToWorld, texels);
        placeLayers(maxLayers());
    }
    Result<void> made = makeProgram(programs);
    if (made) {
        made = holes_.prepare(catalog_, programs, textures);
    }
    if (made) {
        made = makeTexture(texels, neededLayers());
    }
    if (!made) {
        views_.clear();
        layers_.clear();
        return made;
    }
    planLayers(hasChanged());
    return {};
}

/// As many texels per side as all layers have room for.
int ShadowMaps::texelsFor(int layers) const {
    int texels = maxTexels_;
    while (texels > minTexels && std::int64_t(4) * texels * texels * layers > maxBytes) {
        texels /= 2;
    }
    return texels;
}

bool ShadowMaps::hasChanged() const {
    return boxes_ != drawnBoxes_ || serials_ != drawnSerials_ || holesOf_ != drawnHolesOf_ ||
           holes_.hasChanged();
}

void ShadowMaps::makeViews(const Scene& scene, const Scene& effects,
                           const glm::dmat4& cameraToWorld, int texels) {
    views_.assign(scene.lights.size(), ShadowView());
    if (boxes_.empty() || !hasShadows(effects, *catalog_)) {
        return;
    }
    for (std::size_t i = 0; i < views_.size(); ++i) {
        if (const Block* light = shadowedLight(effects.lights[i], *catalog_)) {
            views_[i] = shadowViewOf(*light, scene.lights[i].block.parameters, cameraToWorld,
                                     boxes_, texels);
        }
    }
}

int ShadowMaps::neededLayers() const {
    int layers = 0;
    for (const ShadowView& view : views_) {
        layers += view.faces;
    }
    return layers;
}

/// One after the other; a light that does not fit has no map.
void ShadowMaps::placeLayers(int most) {
    int next = 0;
    lost_ = 0;
    for (ShadowView& view : views_) {
        if (next + view.faces > most) {
            view = ShadowView();
            ++lost_;
            continue;
        }
        view.layer = next;
        next += view.faces;
    }
}

void ShadowMaps::planLayers(bool allAnew) {
    layers_.resize(static_cast<std::size_t>(neededLayers()));
    for (const ShadowView& view : views_) {
        for (int face = 0; face < view.faces; ++face) {
            Layer& layer = layers_[static_cast<std::size_t>(view.layer + face)];
            layer.isDrawn = layer.isDrawn && !allAnew && layer.view == view && layer.face == face;
            layer.view = view;
            layer.face = face;
        }
    }
    if (allAnew) {
        drawnBoxes_ = boxes_;
        drawnSerials_ = serials_;
        drawnHolesOf_ = holesOf_;
        holes_.noteDrawn();
    }
}

Result<void> ShadowMaps::makeProgram(ProgramCache& programs) {
    if (program_) {
        return {};
    }
    const auto source = shadowMapProgram(*catalog_);
    if (!source) {
        return tl::unexpected(source.error().front());
    }
    const ProgramCache::Found found = programs.get(*source);
    if (!found.program) {
        return tl::unexpected(found.errors.front());
    }
    program_ = found.program;
    return {};
}

Result<void> ShadowMaps::makeTexture(int texels, int layers) {
    if (texture_.size().x == texels && texture_.layers() == layers) {
        return {};
    }
    layers_.clear();
    texture_ = gl::TextureArray();
    while (glGetError() != GL_NO_ERROR) {
    }
    texture_ = gl::TextureArray::create(glm::ivec2(texels), layers, GL_DEPTH_COMPONENT32F);
    if (glGetError() == GL_OUT_OF_MEMORY) {
        texture_ = gl::TextureArray();
        return failure("there is not enough graphics memory for the shadows");
    }
    if (framebuffer_.name() == 0) {
        framebuffer_ = gl::Framebuffer::create();
    }
    hasNewImages_ = true;
    framebuffer_.attachDepth(texture_, 0);
    return framebuffer_.check();
}

int ShadowMaps::pending() const {
    return static_cast<int>(std::count_if(layers_.begin(), layers_.end(),
                                          [](const Layer& layer) { return !layer.isDrawn; }));
}

std::int64_t ShadowMaps::pendingTriangles() const {
    std::int64_t triangles = 0;
    for (const GpuMesh* mesh : meshes_) {
        triangles += mesh->triangles();
    }
    return triangles * pending();
}

void ShadowMaps::drawSome(int triangles, FrameTextures& textures) {
    std::int64_t left = triangles;
    while (left > 0 && layer_ < layers_.size()) {
        Layer& layer = layers_[layer_];
        if (layer.isDrawn || (isBegun_ && run_ == runs_.size())) {
            layer.isDrawn = true;
            isBegun_ = false;
            ++layer_;
            continue;
        }
        beginLayer(layer, static_cast<int>(layer_));
        while (left > 0 && run_ < runs_.size()) {
            const Run& run = runs_[run_];
            beginRun(layer, textures);
            const DrawRange range = slices_.next(run.mesh->triangles(), run.first, run.count, left);
            run.mesh->draw(instances_, range);
            left -= range.total();
            if (slices_.isDone(run.count)) {
                slices_ = DrawSlices();
                ++run_;
            }
        }
    }
}

/// What the layer shows, sorted by mesh.
void ShadowMaps::gather(const Layer& layer) {
    if (byMesh_.size() != meshes_.size()) {
        byMesh_.resize(meshes_.size());
        std::iota(byMesh_.begin(), byMesh_.end(), std::size_t(0));
        std::ranges::sort(byMesh_, std::less<>(), [this](std::size_t caster) {
            return std::pair(serials_[caster], caster);
        });
    }
    const glm::dmat4 worldToMap = shadowClip(layer.view, layer.face);
    runs_.clear();
    instances_.clear();
    for (const std::size_t caster : byMesh_) {
        if (!isSeen(worldToMap, caster)) {
            continue;
        }
        const bool isLike = !runs_.empty() && runs_.back().mesh == meshes_[caster] &&
                            runs_.back().holes == holesOf_[caster];
        if (!isLike) {
            runs_.push_back({meshes_[caster], instances_.size(), 0, holesOf_[caster]});
        }
        ++runs_.back().count;
        instances_.add(instanceAt(boxes_[caster].world));
    }
    instances_.upload();
    run_ = 0;
    slices_ = DrawSlices();
    isBegun_ = true;
}

/// Everything is drawn from both sides, so that open meshes cast shadows too.
void ShadowMaps::beginLayer(const Layer& layer, int index) {
    framebuffer_.attachDepth(texture_, index);
    glViewport(0, 0, texture_.size().x, texture_.size().y);
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LESS);
    glDisable(GL_CULL_FACE);
    glDisable(GL_BLEND);
    if (!isBegun_) {
        glClear(GL_DEPTH_BUFFER_BIT);
        gather(layer);
    }
}

void ShadowMaps::beginRun(const Layer& layer, FrameTextures& textures) {
    const glm::mat4 worldToMap(shadowClip(layer.view, layer.face));
    if (runs_[run_].holes != solid) {
        holes_.use(runs_[run_].holes, worldToMap, textures);
        return;
    }
    program_->use();
    glUniformMatrix4fv(program_->uniform("worldToMap"), 1, GL_FALSE, glm::value_ptr(worldToMap));
}

/// False when the caster's box lies beyond one side of the map.
bool ShadowMaps::isSeen(const glm::dmat4& worldToMap, std::size_t caster) const {
    const glm::dmat4 clip = worldToMap * boxes_[caster].world;
    glm::bvec4 outside(true);
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec4 x = clip * cornerOf(boxes_[caster].bounds, corner);
        outside.x = outside.x && x.x < -x.w;
        outside.y = outside.y && x.x > x.w;
        outside.z = outside.z && x.y < -x.w;
        outside.w = outside.w && x.y > x.w;
    }
    return !glm::any(outside);
}

void ShadowMaps::bind() const {
    if (texture_.name() != 0) {
        glActiveTexture(GL_TEXTURE0 + binding::shadowMaps);
        glBindTexture(GL_TEXTURE_2D_ARRAY, texture_.name());
        glActiveTexture(GL_TEXTURE0);
    }
}

} // namespace patina
