// SPDX-License-Identifier: GPL-3.0-or-later
// The part of FrameDrawer that draws shadows and the ground.
#include <algorithm>
#include <limits>

#include <epoxy/gl.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render/binding.h"
#include "render/data_packer.h"
#include "render/frame_drawer.h"
#include "shading/effect_choice.h"

namespace patina {
namespace {

/// The ground reaches so many times as far as the objects.
constexpr double groundReach = 12.0;

/// So much of the objects' size the ground lies below their lowest point.
constexpr double lieBelow = 5e-4;

/// Triangles that are drawn before the clock is asked.
constexpr int slice = 16384;

/// A box in the world around the boxes of all objects.
struct WorldBox {
    glm::dvec3 lower{std::numeric_limits<double>::infinity()};
    glm::dvec3 upper{-std::numeric_limits<double>::infinity()};

    void add(const Bounds& bounds, const glm::dmat4& world) {
        for (int corner = 0; !bounds.empty() && corner < 8; ++corner) {
            const glm::dvec3 x(world * cornerOf(bounds, corner));
            lower = glm::min(lower, x);
            upper = glm::max(upper, x);
        }
    }
    bool isUsable() const {
        return lower.x <= upper.x && glm::length(upper - lower) < 1e9;
    }
};

void setGroundBlending(GroundMode mode) {
    glEnable(GL_BLEND);
    glDepthFunc(GL_LESS);
    const bool isPlane = mode == GroundMode::Plane;
    glDepthMask(isPlane ? GL_TRUE : GL_FALSE);
    // Shadows multiply what is there.
    glBlendFuncSeparate(isPlane ? GL_SRC_ALPHA : GL_ZERO,
                        isPlane ? GL_ONE_MINUS_SRC_ALPHA : GL_SRC_COLOR, GL_ZERO, GL_ONE);
}

} // namespace

void FrameDrawer::planShadows(const Scene& scene) {
    shadows_.clearCasters();
    for (const Item& item : items_) {
        if (isCaster(scene.objects[item.index])) {
            shadows_.addCaster(*item.mesh, item.view.bounds, item.world);
        }
    }
    const int before = pipelines_.programs().compiledCount();
    auto planned = shadows_.plan(scene, *effects_, cameras_.cameraToWorld, pipelines_.programs());
    report_.compiled += pipelines_.programs().compiledCount() - before;
    shadowError_ = planned ? std::nullopt : std::optional(planned.error());
    report_.shadowMaps = shadows_.pending();
}

bool FrameDrawer::drawShadows(Deadline deadline) {
    while (shadows_.pending() > 0) {
        shadows_.drawSome(deadline == never ? std::numeric_limits<int>::max() : slice);
        if (shadows_.pending() > 0 && mustStop(deadline)) {
            return false;
        }
    }
    return true;
}

/// The lowest height of an object's mesh; looked up again only when the object has changed.
double FrameDrawer::lowestHeight(const Item& item) {
    if (ground_.lowest.size() <= item.index) {
        ground_.lowest.resize(item.index + 1);
        ground_.lowestOf.resize(item.index + 1);
    }
    auto& [world, height] = ground_.lowest[item.index];
    std::uint64_t& serial = ground_.lowestOf[item.index];
    if (world != item.world || serial != item.mesh->serial()) {
        world = item.world;
        serial = item.mesh->serial();
        height = lowestPoint(item.view, world);
    }
    return height;
}

void FrameDrawer::planGround(const Scene& scene, const View& view) {
    ground_.isSeen = false;
    if (!isSeen(scene.ground) || items_.empty()) {
        return;
    }
    WorldBox box;
    double lowest = std::numeric_limits<double>::infinity();
    for (const Item& item : items_) {
        box.add(item.view.bounds, item.world);
        lowest = std::min(lowest, lowestHeight(item));
    }
    const double size = 0.5 * glm::length(box.upper - box.lower);
    // A little lower, so that a flat mesh that lies on it is seen.
    const double height = scene.ground.automatic ? lowest - lieBelow * size : scene.ground.height;
    const double above = eye(view.camera).y - height;
    if (!box.isUsable() || !(above > 0.0)) {
        return;
    }
    ground_.isSeen = true;
    ground_.place.middle = glm::dvec3(0.5 * (box.lower.x + box.upper.x), height,
                                      0.5 * (box.lower.z + box.upper.z));
    ground_.place.radius = groundReach * std::max(size, 1e-6);
    const glm::dvec3 middle(cameras_.worldToCamera * glm::dvec4(ground_.place.middle, 1.0));
    depths_.add(0.2 * above);
    depths_.add(-middle.z + 1.5 * ground_.place.radius);
}

void FrameDrawer::chooseGround(std::uint64_t sceneKey) {
    if (!ground_.isSeen || !isSeen(effects_->ground)) {
        ground_.isSeen = false;
        return;
    }
    const PipelineStore::Entry& entry = pipelines_.ground(*effects_, sceneKey);
    ground_.pipeline = entry.pipeline ? entry.pipeline : ground_.pipeline;
    ground_.isSeen = ground_.pipeline && ground_.pipeline->effects.ground != GroundMode::Off;
    if (!ground_.isSeen) {
        return;
    }
    noteSource(ground_.pipeline.get());
    ground_.data.reserve(static_cast<std::size_t>(ground_.pipeline->object.vec4s));
    if (!ground_.mesh) {
        const Mesh square = groundMesh();
        ground_.mesh.emplace(square.view());
        while (!ground_.mesh->isComplete()) {
            ground_.mesh->upload(square.view(), std::numeric_limits<std::size_t>::max());
        }
    }
}

void FrameDrawer::drawGround(const Scene& scene) {
    if (!ground_.isSeen || cursor_.hasGround) {
        return;
    }
    cursor_.hasGround = true;
    const Pipeline& pipeline = *ground_.pipeline;
    feedScene(scene, pipeline);
    packGround(ground_.data.staging(), pipeline, scene.ground,
               {ground_.place, environment_.upward()});
    report_.uploadedBuffers +=
        ground_.data.upload(static_cast<std::size_t>(pipeline.object.vec4s)) ? 1 : 0;
    ground_.data.bind(binding::object);
    pipeline.program->use();
    setGroundBlending(pipeline.effects.ground);
    ground_.mesh->draw();
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}

} // namespace patina
