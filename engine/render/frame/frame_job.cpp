// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/frame/frame_job.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <boost/container_hash/hash.hpp>
#include <epoxy/gl.h>
#include <glm/common.hpp>

#include "render/gpu/capture_image.h"
#include "render/gpu/stretched_picture.h"
#include "shading/effects/display_set.h"
#include "shading/effects/refraction.h"

namespace patina {
namespace {

/// Limits the bytes of images that a window's frame uploads, which takes some milliseconds.
constexpr std::size_t textureBytesAtOnce = std::size_t(8) << 20;

/// A whole frame that takes at most `longestQuick` needs no sketch. A sketch has about 1 /
/// sketchShare of its work.
constexpr std::chrono::milliseconds longestQuick{48};
constexpr int sketchShare = 8;

/// Returns a view that is half as wide and high, with one sample per pixel.
View sketchOf(const View& view) {
    View few = view;
    few.size = glm::max(view.size / 2, glm::ivec2(1));
    few.samples = 1;
    return few;
}

} // namespace

FrameJob::FrameJob(std::shared_ptr<RenderResources> shared)
    : shared_(std::move(shared)), gpu_(*shared_) {}

void FrameJob::followCatalog() {
    if (catalog_ == shared_->catalog) {
        return;
    }
    catalog_ = shared_->catalog;
    for (Pass* pass : passes_.prepared(gpu_.data)) {
        pass->forget();
    }
    gpu_.environment.forget();
    gpu_.shadows.setCatalog(catalog_);
    description_.forget();
}

void FrameJob::begin(const Scene& scene, const View& view, const MeshSource& meshes,
                     FramePurpose purpose) {
    if (stopwatch_ != nullptr) {
        stopwatch_->start();
    }
    began_ = Clock::now();
    purpose_ = purpose;
    failure_.reset();
    at_ = Cursor();
    isNeedless_ = false;
    hasPicture_ = hasPicture_ && purpose == FramePurpose::Prewarm; // which draws nothing
    if (gpu_.isSketch && purpose != FramePurpose::Sketch) {
        gpu_.sketchTarget = HdrTarget();
    }
    gpu_.isSketch = purpose == FramePurpose::Sketch;
    followCatalog();
    if (catalog_ == nullptr) {
        failure_ = Error{
            {}, 0, 0, "there are no shaders to draw with", "a call of setCatalog before draw"};
        return;
    }
    const bool isPrewarming = purpose == FramePurpose::Prewarm;
    if (isPrewarming) {
        meshes_ = meshes;
    } else if (purpose != FramePurpose::Targets) {
        size_ = view.size;
        exposure_ = scene.exposure;
    }
    view_ = gpu_.isSketch ? sketchOf(view) : view;
    makePlan(scene, meshes);
}

void FrameJob::makePlan(const Scene& scene, const MeshSource& meshes, bool freezesEffects) {
    planner_.make(plan_, scene, view_, meshes, *catalog_,
                  {freezesEffects, purpose_ == FramePurpose::Prewarm});
    prepared_.begin();
    at_ = Cursor();
    budget_.beginFrame();
    shared_->meshes.beginFrame();
    const bool isAll = purpose_ == FramePurpose::Capture;
    gpu_.textures.begin(isAll ? TextureBudget::everything : textureBytesAtOnce);
}

FrameJob::Progress FrameJob::step(Deadline deadline) {
    if (at_.isDone) {
        return Progress::Done;
    }
    if (failure_) {
        return fail(*failure_);
    }
    if (purpose_ == FramePurpose::Prewarm) {
        prewarm();
        return Progress::Done;
    }
    if (purpose_ == FramePurpose::Targets) {
        // The frame itself reports an error of the target.
        static_cast<void>(gpu_.fitTarget(plan_, showsSceneRefracted(*plan_.effects, *catalog_)));
        return Progress::Done;
    }
    gpu_.shadows.noteStep();
    const bool isFirst = std::exchange(at_.isFirstStep, false);
    if (isFirst) {
        beginReport();
    }
    if (!prepare(isFirst ? began_ : Clock::now(), deadline)) {
        return failure_ ? fail(*failure_) : pause();
    }
    lap("preparation");
    if (gpu_.isSketch && isLarge()) {
        isNeedless_ = true; // it would take hardly less than the frame
        return Progress::Done;
    }
    const bool isForLater = isFirst && purpose_ == FramePurpose::Window && deadline != never &&
                            (isLarge() || passes_.solid.tiles().pace() == RowTiles::Pace::Slow);
    return isForLater ? pause() : draw(deadline);
}

void FrameJob::beginReport() {
    FrameReport& report = gpu_.report;
    report.programs = 0;
    report.compiled = 0;
    report.uploadedBuffers = 0;
    report.drawnObjects = 0;
    report.drawCalls = 0;
    report.isWaiting = false;
    report.shadowMaps = 0;
    report.filledTables = 0;
}

/// Copies the scenes, so that the next step does not need the caller's.
FrameJob::Progress FrameJob::pause() {
    if (!std::exchange(at_.isKept, true)) {
        const bool hasOwnEffects = plan_.effects == plan_.scene;
        kept_.scene = *plan_.scene;
        kept_.effects = hasOwnEffects ? std::nullopt : std::optional(*plan_.effects);
        plan_.moveTo(kept_.scene, hasOwnEffects ? kept_.scene : *kept_.effects);
    }
    return Progress::More;
}

FrameJob::Progress FrameJob::fail(const Error& error) {
    description_.writeFailure(gpu_.report, error);
    gpu_.shadows.giveBack();
    isNeedless_ = gpu_.isSketch;
    return Progress::Done;
}

/// Prepares the frame and returns true when it may be drawn in this step. A window's frame is
/// prepared in one piece per step. Drawing may compile too, so it begins only while half of the
/// time is left.
bool FrameJob::prepare(Deadline began, Deadline deadline) {
    const bool isStepwise = purpose_ == FramePurpose::Window && deadline != never;
    const bool wasPrepared = at_.prepared == passCount();
    while (at_.prepared < passCount()) {
        if (!prepareSome() || (isStepwise && at_.prepared < passCount())) {
            return false;
        }
    }
    return wasPrepared || !isStepwise || Clock::now() - began <= (deadline - began) / 2;
}

/// Prepares passes up to the first long step of work; returns false on an error. A pass that has
/// made something is asked again, until it has nothing left to do.
bool FrameJob::prepareSome() {
    ProgramCache& programs = shared_->programs();
    const auto passes = passes_.prepared(gpu_.data);
    for (; at_.prepared < passes.size(); ++at_.prepared) {
        const int built = programs.builtCount();
        const int compiled = programs.compiledCount();
        const Result<bool> made = passes[at_.prepared]->prepare(prepared_, gpu_);
        gpu_.report.compiled += programs.compiledCount() - compiled;
        if (!made) {
            failure_ = made.error();
            return false;
        }
        if (*made || programs.builtCount() > built) {
            return true;
        }
    }
    return true;
}

/// Returns true when the frame has so many triangles that it is drawn in steps.
bool FrameJob::isLarge() {
    return plan_.hasManyTriangles(gpu_.shadows.pendingTriangles());
}

FrameJob::Progress FrameJob::draw(Deadline deadline) {
    const bool isQuick = !isLarge() && passes_.solid.tiles().pace() == RowTiles::Pace::Quick;
    if (!budget_.beginStep(isQuick ? never : deadline)) {
        return pause();
    }
    if (!std::exchange(at_.isDrawing, true)) {
        budget_.beginDrawing(isLarge());
    }
    const bool isDone = drawPasses(passes_.beforeObjects()) && drawObjects() &&
                        drawPass(passes_.depthNormals) && drawPass(passes_.resolve);
    return isDone ? finish() : pause();
}

bool FrameJob::drawPasses(std::span<Pass* const> passes) {
    return std::ranges::all_of(passes, [this](Pass* pass) { return drawPass(*pass); });
}

bool FrameJob::drawPass(Pass& pass) {
    const bool isDone = pass.draw(prepared_, gpu_, budget_);
    lap(pass.name());
    return isDone;
}

void FrameJob::lap(std::string_view name) {
    if (stopwatch_ != nullptr) {
        stopwatch_->lap(name);
    }
}

bool FrameJob::drawObjects() {
    if (at_.areObjectsDrawn) {
        return true;
    }
    gpu_.beginObjects();
    at_.areObjectsDrawn = drawPasses(passes_.objects());
    FrameGpu::endObjects();
    if (!budget_.isEndless()) {
        budget_.mark();
    }
    return at_.areObjectsDrawn;
}

FrameJob::Progress FrameJob::finish() {
    at_.isDone = true;
    hasPicture_ = !gpu_.isSketch;
    shared_->meshes.endFrame();
    shared_->textures.endFrame();
    gpu_.shadows.giveBack();
    gpu_.report.isWaiting = gpu_.textures.budget.isWaiting;
    description_.write(prepared_, gpu_, passes_.programs, passes_.shadows.error());
    isNeedless_ = gpu_.isSketch && Clock::now() - began_ < longestQuick / sketchShare;
    return Progress::Done;
}

/// A frame that was done in its first step has no copy of its scene to compare; it counts as equal.
bool FrameJob::hasMeshesOf(const Scene& scene) const {
    const auto isAlike = [](const Object& a, const Object& b) {
        return a.visible == b.visible && a.mesh == b.mesh && a.part == b.part;
    };
    return (at_.isDone && !at_.isKept) ||
           std::ranges::equal(kept_.scene.objects, scene.objects, isAlike);
}

std::uint64_t FrameJob::missingPrograms() {
    if (failure_) {
        return 0;
    }
    std::size_t missing = passes_.programs.missing(plan_, *shared_);
    if (!passes_.display.has(*plan_.effects, *shared_->catalog)) {
        boost::hash_combine(missing, 1);
    }
    if (purpose_ == FramePurpose::Prewarm && !hasFrozenPrograms()) {
        boost::hash_combine(missing, 2);
    }
    return missing;
}

/// Returns true when all programs are there for drawing while a value is dragged
/// (PlanWish::freezesEffects).
bool FrameJob::hasFrozenPrograms() {
    return passes_.display.has(*plan_.effects, *shared_->catalog) &&
           passes_.programs.hasFrozen(plan_, *shared_);
}

/// Makes the programs of the picture, and those for drawing while a value is dragged.
void FrameJob::prewarm() {
    const bool isMissing = passes_.programs.missing(plan_, *shared_) != 0;
    if (isMissing || !passes_.display.has(*plan_.effects, *shared_->catalog)) {
        drawUnseen();
    }
    if (!hasFrozenPrograms()) {
        makePlan(*plan_.scene, meshes_, true);
        drawUnseen();
    }
    meshes_ = nullptr;
}

/// Draws the frame with an empty scissor rectangle, because drivers put work off until a program is
/// drawn with. With very many triangles that would take longer than it saves, so they are not
/// drawn. What releaseTargets() has left of the target is laid aside; a whole one that is made anew
/// has no picture any more.
void FrameJob::drawUnseen() {
    FrameReport before = gpu_.report;
    std::optional<HdrTarget> kept;
    if (hasPicture_ && gpu_.frameTarget.depth().name() == 0) {
        kept = std::exchange(gpu_.frameTarget, HdrTarget());
    }
    const auto isNew = gpu_.fitTarget(plan_, showsSceneRefracted(*plan_.effects, *catalog_));
    hasPicture_ = hasPicture_ && (kept || (isNew && !*isNew) || gpu_.environment.hasPicture());
    if (prepare(began_, never) && !isLarge()) {
        budget_.beginStep(never);
        drawPasses(passes_.beforeObjects());
        glEnable(GL_SCISSOR_TEST);
        glScissor(0, 0, 0, 0);
        drawObjects();
        passes_.depthNormals.draw(prepared_, gpu_, budget_);
        gpu_.environment.addUnseen(gpu_.target().resolved(), *catalog_, shared_->programs());
        glDisable(GL_SCISSOR_TEST);
        leaveState();
    }
    if (kept) {
        gpu_.frameTarget = std::move(*kept);
    }
    failure_.reset();
    gpu_.shadows.giveBack();
    gpu_.report = std::move(before);
}

bool FrameJob::takePasses(const Scene& scene, const Scene& effects) {
    if (!hasPicture() || catalog_ != shared_->catalog) {
        return false;
    }
    const bool needsSurfaces = displaySet(effects, *catalog_).readSurfaces();
    if ((needsSurfaces && !passes_.depthNormals.isThere()) ||
        !passes_.display.take(scene, effects, *catalog_)) {
        return false;
    }
    exposure_ = scene.exposure;
    return true;
}

void FrameJob::show(unsigned framebuffer, double share) {
    if (failure_) {
        return;
    }
    if (!gpu_.isSketch) {
        showIn(framebuffer, size_, exposure_, share);
        lap("picture passes and tone curve");
        return;
    }
    const StretchedPicture picture(view_.size);
    showIn(picture.framebuffer(), view_.size, exposure_);
    if (!picture.draw({framebuffer, size_}, *catalog_, shared_->programs())) {
        picture.show(framebuffer, size_);
    }
    leaveState();
}

void FrameJob::showIn(unsigned framebuffer, glm::ivec2 size, double exposure, double share) {
    glViewport(0, 0, size.x, size.y);
    passes_.depthNormals.bind();
    passes_.display.show(gpu_.picture(), framebuffer, exposure, share);
    leaveState();
}

Result<Image> FrameJob::read(bool display, std::optional<double> exposure) {
    if (failure_) {
        return tl::unexpected(*failure_);
    }
    const double shown = exposure.value_or(exposure_);
    if (!display) {
        return readLinear(gpu_.pictureFramebuffer(), size_, shown);
    }
    return readDisplay(size_,
                       [this, shown](unsigned framebuffer) { showIn(framebuffer, size_, shown); });
}

/// Where no picture stays it draws one pixel at the end, because a driver may keep the images that
/// were drawn with last until others are.
void FrameJob::releaseTargets() {
    passes_.layers.release();
    passes_.blended.release();
    gpu_.sketchTarget = HdrTarget();
    gpu_.isSketch = false;
    if (hasPicture() && passes_.display.hasPasses()) {
        passes_.display.release();
        gpu_.frameTarget.keepResolved();
        return;
    }
    hasPicture_ = false;
    passes_.depthNormals.release();
    if (!passes_.display.isPrepared() || !gpu_.frameTarget.fit(glm::ivec2(1), 1, false)) {
        gpu_.frameTarget = HdrTarget();
        return;
    }
    gpu_.frameTarget.bind();
    passes_.display.show(gpu_.frameTarget.resolved(), gpu_.frameTarget.framebuffer(), 0.0);
    passes_.display.release();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    leaveState();
}

} // namespace patina
