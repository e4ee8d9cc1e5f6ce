// SPDX-License-Identifier: GPL-3.0-or-later
// The part of FrameDrawer that prepares a frame, piece by piece where a window must not stand
// still.
#include <array>
#include <utility>

#include "render/frame/frame_drawer.h"
#include "render/gpu/long_pieces.h"
#include "render/pass/data_packer.h"
#include "shading/effects/refraction.h"

namespace patina {

bool FrameDrawer::begin(const Scene& scene, const View& view, const MeshSource& meshes,
                        Purpose purpose) {
    if (!plan(scene, view, meshes, purpose)) {
        return false;
    }
    while (!isPrepared()) {
        if (!prepareSome(scene, view)) {
            return false;
        }
    }
    return true;
}

bool FrameDrawer::plan(const Scene& scene, const View& view, const MeshSource& meshes,
                       Purpose purpose) {
    report_.programs = 0;
    report_.compiled = 0;
    report_.uploadedBuffers = 0;
    report_.drawnObjects = 0;
    report_.drawCalls = 0;
    report_.isWaiting = false;
    report_.shadowMaps = 0;
    report_.filledTables = 0;
    lostLights_ = 0;
    cursor_ = Cursor();
    fence_ = gl::Fence();
    purpose_ = purpose;
    stage_ = 0;
    hasFailed_ = false;
    effects_ = &effectsOf(view, scene);
    heldEffects_ = prewarmsHeld_ || effects_ != &scene;
    if (catalog_ == nullptr) {
        return fail({{}, 0, 0, "there are no shaders to draw with",
                     "a call of setCatalog before draw"});
    }
    textures_.beginFrame(textureBytes_);
    meshes_.beginFrame();
    collect(scene, view, meshes, purpose);
    count();
    planGround(scene, view);
    makeRoomForLights();
    return true;
}

std::span<const FrameDrawer::Stage> FrameDrawer::stages() {
    static constexpr std::array<Stage, 8> all{
        &FrameDrawer::prepareShadows, &FrameDrawer::prepareDisplay, &FrameDrawer::prepareTarget,
        &FrameDrawer::prepareEnvironment, &FrameDrawer::preparePrograms,
        &FrameDrawer::prepareData, &FrameDrawer::prepareLayers, &FrameDrawer::prepareRefraction};
    return all;
}

bool FrameDrawer::isPrepared() const {
    return stage_ > stages().size();
}

/// A stage that has made something is asked again, until there is nothing left for it to do.
bool FrameDrawer::prepareSome(const Scene& scene, const View& view) {
    while (stage_ < stages().size()) {
        const int built = pipelines_.programs().builtCount();
        const int compiled = pipelines_.programs().compiledCount();
        const Result<bool> made = (this->*stages()[stage_])(scene, view);
        report_.compiled += pipelines_.programs().compiledCount() - compiled;
        if (!made) {
            return fail(made.error());
        }
        if (*made || pipelines_.programs().builtCount() > built) {
            return true;
        }
        ++stage_;
    }
    startDrawing(scene, view);
    ++stage_;
    return true;
}

void FrameDrawer::startDrawing(const Scene& scene, const View& view) {
    pace_.begin(isLarge());
    tiles_.begin(sources_, target_.drawnSize(), triangles_, environment_.rounds());
    clear(scene, view);
}

bool FrameDrawer::fail(Error error) {
    hasFailed_ = true;
    report_.messages.assign(1, std::move(error));
    report_.warnings = 0;
    report_.effects.clear();
    describedLost_ = -1;
    return false;
}

Result<bool> FrameDrawer::prepareDisplay(const Scene&, const View&) {
    ProgramCache& programs = pipelines_.programs();
    const auto prepared = purpose_ == Purpose::Prewarming
                              ? display_.prewarm(*effects_, *catalog_, programs)
                              : display_.prepare(*effects_, *catalog_, programs);
    return prepared.map([] { return false; });
}

Result<bool> FrameDrawer::prepareShadows(const Scene& scene, const View&) {
    planShadows(scene);
    return shadows_.hasNewImages();
}

Result<bool> FrameDrawer::prepareTarget(const Scene& scene, const View& view) {
    const auto isNew = fitTarget(scene.accuracy, view, showsSceneRefracted(*effects_, *catalog_));
    return isNew.map([this](bool made) { return made && takesLong(target_.drawnSize()); });
}

Result<bool> FrameDrawer::prepareEnvironment(const Scene& scene, const View& view) {
    const SceneToPack packing{scene, *effects_, {}};
    if (purpose_ == Purpose::Prewarming) {
        environment_.prewarm(packing, view, *catalog_, pipelines_.programs());
        return false;
    }
    return environment_.begin(packing, view, *catalog_, pipelines_.programs());
}

Result<bool> FrameDrawer::preparePrograms(const Scene&, const View&) {
    choosePipelines();
    return false;
}

Result<bool> FrameDrawer::prepareData(const Scene& scene, const View& view) {
    uploadView(view);
    orderItems();
    fillTables(scene);
    return false;
}

Result<bool> FrameDrawer::prepareLayers(const Scene& scene, const View&) {
    return beginLayers(scene);
}

/// A program from before a change may look at what others do not.
Result<bool> FrameDrawer::prepareRefraction(const Scene& scene, const View& view) {
    if (auto begun = beginRefraction(); !begun || *begun) {
        return begun;
    }
    return refraction_ && refraction_->looksBehind() ? fitTarget(scene.accuracy, view, true)
                                                     : Result<bool>(false);
}

/// More triangles than pixels are dense.
Result<bool> FrameDrawer::fitTarget(const PictureAccuracy& accuracy, const View& view,
                                    bool isReadBetween) {
    const double scale = accuracy.scale();
    const double pixels = scale * view.size.x * (scale * view.size.y);
    const HdrNumbers numbers = accuracy.hasWholeNumbers() ? HdrNumbers::Full : view.numbers;
    const int samples = view.samples > 0 ? view.samples : accuracy.samples();
    return target_.fit(view.size, samples, static_cast<double>(triangles_) > pixels, numbers,
                       scale, isReadBetween);
}

} // namespace patina
