// SPDX-License-Identifier: GPL-3.0-or-later
// The part of FrameDrawer that draws shadows and the ground.
#include <limits>

#include <epoxy/gl.h>

#include "render/frame/frame_drawer.h"
#include "render/gpu/binding.h"
#include "render/pass/data_packer.h"

namespace patina {
namespace {

/// Triangles that are drawn before the clock is asked.
constexpr int slice = 16384;

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
    for (const DrawItem& item : items_) {
        const Object& object = scene.objects[item.index];
        if (object.castsShadow && materials_[item.material].canShadow) {
            shadows_.addCaster(*item.mesh, {item.view.bounds, item.placement->world},
                               object.material);
        }
    }
    auto planned = shadows_.plan(scene, *effects_, cameras_.cameraToWorld, pipelines_.programs(),
                                 textures_);
    shadowError_ = planned ? std::nullopt : std::optional(planned.error());
    report_.shadowMaps = shadows_.pending();
}

bool FrameDrawer::drawShadows(Deadline deadline) {
    while (shadows_.pending() > 0) {
        shadows_.drawSome(deadline == never ? std::numeric_limits<int>::max() : slice, textures_);
        if (mustStop(deadline)) {
            return false;
        }
    }
    return true;
}

/// The lowest height of an object's mesh; looked up again only when the object has changed.
double FrameDrawer::lowestHeight(const DrawItem& item) {
    if (ground_.lowest.size() <= item.index) {
        ground_.lowest.resize(item.index + 1);
        ground_.lowestOf.resize(item.index + 1);
    }
    auto& [world, height] = ground_.lowest[item.index];
    std::uint64_t& serial = ground_.lowestOf[item.index];
    if (world != item.placement->world || serial != item.mesh->serial()) {
        world = item.placement->world;
        serial = item.mesh->serial();
        height = lowestPoint(item.view, world);
    }
    return height;
}

/// While its opacity is dragged the ground is there at 0 too.
void FrameDrawer::planGround(const Scene& scene, const View& view) {
    ground_.isSeen = false;
    if (!isSeen(effects_->ground)) {
        return;
    }
    GroundUnder under;
    for (const DrawItem& item : items_) {
        under.add(item.view.bounds, item.placement->world, lowestHeight(item));
    }
    const auto place = under.place(scene.ground, eye(view.camera));
    if (place) {
        ground_.isSeen = true;
        ground_.place = *place;
        ground_.lights = lightLists_.listFor(ballAround(*place));
        addGround(depths_, *place, view.camera);
    }
}

void FrameDrawer::chooseGround() {
    if (!ground_.isSeen) {
        return;
    }
    const PipelineStore::Entry& entry =
        pipelines_.ground(surroundings(missingKinds(ground_.lights)));
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
    feedScene(scene, pipeline, ground_.lights);
    packGround(ground_.data.staging(), pipeline, scene.ground,
               {ground_.place, environment_.upward()});
    report_.uploadedBuffers +=
        ground_.data.upload(static_cast<std::size_t>(pipeline.object.vec4s)) ? 1 : 0;
    ground_.data.bind(binding::object);
    pipeline.program->use();
    setGroundBlending(pipeline.effects.ground);
    ground_.instance.place(worldMatrix(ground_.place));
    ground_.mesh->draw(ground_.instance);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}

} // namespace patina
