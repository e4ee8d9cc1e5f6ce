// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/frame/frame_drawer.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include <epoxy/gl.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "gl/driver.h"
#include "render/gpu/binding.h"
#include "render/gpu/hdr_numbers.h"
#include "render/pass/data_packer.h"
#include "render/pass/refraction_packer.h"
#include "shading/effects/material_hash.h"
#include "shading/effects/opacity.h"
#include "shading/effects/outline.h"
#include "shading/effects/shadows.h"

namespace patina {
namespace {

using Clock = std::chrono::steady_clock;

/// Frames of more triangles are drawn in steps when there is a deadline.
constexpr std::int64_t maxTrianglesAtOnce = 200000;

constexpr std::size_t uploadBytes = std::size_t(4) << 20;

/// Neighbours often are, and then it need not be looked up.
bool isOfOneMesh(const Object& a, const Object& b) {
    return a.mesh == b.mesh && a.fitUnitBox == b.fitUnitBox && a.flipNormals == b.flipNormals;
}

} // namespace

const Scene& FrameDrawer::effectsOf(const View& view, const Scene& scene) {
    const bool fits = view.effects != nullptr &&
                      view.effects->objects.size() == scene.objects.size() &&
                      view.effects->lights.size() == scene.lights.size();
    return fits ? *view.effects : scene;
}

FrameDrawer::FrameDrawer(std::filesystem::path programCache)
    : pipelines_(std::move(programCache)), isSoftware_(gl::isSoftware()) {
    viewData_.reserve(ViewLayout::vec4s);
}

void FrameDrawer::setCatalog(std::shared_ptr<const Catalog> catalog) {
    catalog_ = std::move(catalog);
    pipelines_.setCatalog(catalog_);
    shadows_.setCatalog(catalog_);
    display_.forget();
    environment_.forget();
    transparency_.forget();
    refraction_.reset();
    described_.clear();
    describedLost_ = -1;
}

/// What is behind the objects.
void FrameDrawer::clear(const Scene& scene, const View& view) {
    target_.bind();
    glClearColor(storable(scene.background.x), storable(scene.background.y),
                 storable(scene.background.z), 1.0f);
    glDepthMask(GL_TRUE);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    environment_.drawBackground(view.camera, cameras_.cameraToWorld,
                                double(view.size.x) / double(view.size.y));
}

bool FrameDrawer::proceed(const Scene& scene, const View& view, Deadline deadline) {
    effects_ = &effectsOf(view, scene); // both may have moved since the last turn
    while (!isPrepared()) {
        if (!prepareSome(scene, view)) {
            return true;
        }
        if (deadline != never) {
            return false;
        }
    }
    const bool quick = !isLarge() && pace() == RowTiles::Pace::Quick;
    const Deadline limit = quick ? never : deadline;
    if (!deviceIsDone(limit)) {
        return false;
    }
    pace_.passed(Clock::now()); // what the last step did not wait for
    if (!uploadMeshes(limit) || !drawShadows(limit) || !drawTiles(scene, limit) ||
        !resolve(limit)) {
        return false;
    }
    meshes_.endFrame();
    textures_.endFrame();
    report_.isWaiting = textures_.isWaiting();
    describe();
    effects_ = nullptr;
    return true;
}

bool FrameDrawer::deviceIsDone(Deadline deadline) {
    return fence_.passed(deadline - Clock::now());
}

void FrameDrawer::collect(const Scene& scene, const View& view, const MeshSource& meshes,
                          Purpose purpose) {
    cameras_.worldToCamera = viewMatrix(view.camera);
    cameras_.cameraToWorld = glm::inverse(cameras_.worldToCamera);
    depths_ = DepthRange();
    items_.clear();
    materials_.clear();
    materialKeys_.clear(scene.objects.size());
    placements_.makeRoom(scene.objects.size());
    lightLists_.begin(scene, *catalog_);
    lightKinds_.begin(*effects_, *catalog_);
    const double aspect = double(view.size.x) / double(view.size.y);
    const glm::dmat4 worldToClip =
        projection(view.camera, aspect, depths_) * cameras_.worldToCamera;
    const glm::dvec3 origin = eye(view.camera);
    const Object* last = nullptr; // of which `mesh` is
    MeshView mesh;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const Object& object = scene.objects[i];
        if (!isDrawn(object)) {
            continue;
        }
        if (last == nullptr || !isOfOneMesh(*last, object)) {
            mesh = meshes(object);
            last = &object;
        }
        if (mesh.indices.empty()) {
            continue;
        }
        const Placement& place = placements_.of(i, object, mesh.bounds);
        const std::size_t lights = lightLists_.listFor(place.ball);
        if (!mesh.bounds.empty()) {
            depths_.add(place.corners, cameras_.worldToCamera);
        }
        items_.push_back({i, mesh, &meshes_.prepare(mesh), &place,
                          glm::distance(place.middle, origin), lights,
                          materialOf(scene, i, missingKinds(lights)),
                          purpose == Purpose::Prewarming || !isOutside(place, worldToClip)});
    }
}

/// Which lights the objects of a list have no code for. While a value is dragged the lists are data
/// alone.
std::size_t FrameDrawer::missingKinds(std::size_t lights) {
    return heldEffects_ ? 0 : lightKinds_.missingKinds(lightLists_, lights);
}

/// The number of an object's material. Two objects share one when both its values and the effects
/// of their programs are the same.
std::size_t FrameDrawer::materialOf(const Scene& scene, std::size_t object, std::size_t missing) {
    const Material& effects = effects_->objects[object].material;
    std::uint64_t hash = materialHash(effects);
    if (heldEffects_) {
        hash = 31 * hash + materialHash(scene.objects[object].material);
    }
    if (missing != 0) {
        hash = 31 * hash + missing;
    }
    const std::size_t number = materialKeys_.find(hash, materials_.size());
    if (number == materials_.size()) {
        const bool isOutlined = outlineChoice(effects, *catalog_).block != nullptr;
        materials_.push_back({object,
                              missing,
                              isTransparent(effects, *catalog_),
                              canShadow(scene.objects[object].material, *catalog_),
                              isOutlined,
                              nullptr,
                              {},
                              {}});
    }
    return number;
}

void FrameDrawer::makeRoomForLights() {
    while (sceneData_.size() < lightLists_.count()) {
        sceneData_.emplace_back().reserve(static_cast<std::size_t>(pipelines_.sceneCapacity()));
        fedScenes_.push_back(nullptr);
    }
}

void FrameDrawer::count() {
    triangles_ = 0;
    edges_ = 0;
    for (const DrawItem& item : items_) {
        triangles_ += item.mesh->triangles();
        // A closed mesh has three edges for two triangles.
        edges_ += materials_[item.material].isOutlined ? 3 * item.mesh->triangles() / 2 : 0;
    }
}

bool FrameDrawer::isLarge() const {
    return triangles_ + edges_ + shadows_.pendingTriangles() > maxTrianglesAtOnce;
}

bool FrameDrawer::uploadMeshes(Deadline deadline) {
    for (const DrawItem& item : items_) {
        while (!item.mesh->isComplete()) {
            item.mesh->upload(item.view, uploadBytes);
            if (Clock::now() >= deadline) {
                return false;
            }
        }
    }
    return findEdges(deadline);
}

void FrameDrawer::uploadView(const View& view) {
    const double aspect = double(view.size.x) / double(view.size.y);
    const glm::dmat4 worldToClip =
        projection(view.camera, aspect, depths_) * cameras_.worldToCamera;
    measurePixel(view, worldToClip);
    packView(viewData_.staging(), worldToClip, eye(view.camera), target_.pixelWidth());
    report_.uploadedBuffers += viewData_.upload(ViewLayout::vec4s) ? 1 : 0;
    viewData_.bind(binding::view);
}

/// The mean of an environment's frames is a step of its own.
bool FrameDrawer::resolve(Deadline deadline) {
    if (!deviceIsDone(deadline)) {
        return false;
    }
    if (!std::exchange(cursor_.resolved, true)) {
        target_.resolve();
        target_.stretch();
        if (environment_.isIn() && deadline != never && mustStop(deadline)) {
            return false;
        }
    }
    if (!std::exchange(cursor_.isAdded, true)) {
        if (environment_.isIn()) {
            environment_.add(target_.resolved());
        }
        if (deadline != never) {
            fence_ = gl::Fence::afterCommandsSoFar();
        }
    }
    return deviceIsDone(deadline);
}

void FrameDrawer::feed(const Scene& scene, const DrawBatch& batch) {
    const DrawMaterial& material = materials_[batch.material];
    feedScene(scene, *material.pipeline, batch.lights);
    if (fedMaterial_ != batch.material) {
        feedMaterial(scene, material);
        fedMaterial_ = batch.material;
    }
}

void FrameDrawer::feedMaterial(const Scene& scene, const DrawMaterial& material) {
    const Pipeline& pipeline = *material.pipeline;
    const std::span<glm::vec4> data = materialData_.staging(material.data);
    const Material& values = scene.objects[material.object].material;
    if (pipeline.tableProgram) {
        tables_.bind(static_cast<std::size_t>(&material - materials_.data()));
    }
    packMaterial(data, pipeline, values, cameras_.cameraToWorld);
    if (isLayered(material)) {
        packLayersOf(scene, material, data);
    }
    if (refracts(material)) {
        packRefraction(data, pipeline, values, scene.background);
    }
    textures_.bind(data, pipeline, values);
    report_.uploadedBuffers += materialData_.upload(material.data) ? 1 : 0;
    materialData_.bind(binding::object, material.data);
    pipeline.program->use();
}

/// Programs that were made for the same scene read the same data; one that is left over from
/// before a change that does not compile may read other data.
void FrameDrawer::feedScene(const Scene& scene, const Pipeline& pipeline, std::size_t lights) {
    UniformBuffer& data = sceneData_[lights];
    const Pipeline* fed = fedScenes_[lights];
    if (fed == nullptr || fed->sceneKey != pipeline.sceneKey || fed->catalog != pipeline.catalog) {
        const PackedScene packed = packScene(
            data.staging(), pipeline, {scene, *effects_, shadows_.views(), &lightLists_, lights},
            cameras_.cameraToWorld);
        report_.uploadedBuffers += data.upload(packed.vec4s) ? 1 : 0;
        lostLights_ = std::max(lostLights_, packed.lostLights);
        fedScenes_[lights] = &pipeline;
    }
    data.bind(binding::scene);
}

} // namespace patina
