// SPDX-License-Identifier: GPL-3.0-or-later
// The part of Viewport that has programs made: those a frame waits for, and those that may be
// wanted soon.
#include <utility>

#include "render/frame/frame_job.h"
#include "viewport/program_worker.h"
#include "viewport/viewport.h"

namespace patina {

/// Whether the frame to be drawn lacks programs that are made elsewhere meanwhile. The first frame
/// has no window yet that could stand still. What came and is still lacking was not kept by the
/// driver or the disk: it is made here.
bool Viewport::waitsForPrograms(FrameJob& job) {
    if (!sources_.programs || frameCount_ == 0) {
        return false;
    }
    const std::uint64_t missing = job.missingPrograms();
    if (missing == 0 || (ordered_.number == 0 && ordered_.missing == missing)) {
        ordered_ = {};
        return false;
    }
    ordered_ = {askFor(sources_.scene(), view()), missing};
    ++waitCount_;
    goOnWith(Progress::Waiting);
    if (isNew_) {
        showNote();
    }
    return true;
}

/// Meanwhile; it takes as long as several steps of a frame.
void Viewport::makeTargets() {
    makeCurrent();
    beginJob(FramePurpose::Targets).step(FrameJob::never);
    doneCurrent();
}

quint64 Viewport::askFor(const Scene& scene, const View& view) {
    ProgramWorker::Frame frame{scene, {}, view, {}, 0, catalog_};
    if (view.effects) {
        frame.effects = *view.effects;
    }
    frame.view.effects = nullptr;
    frame.view.environmentImage = nullptr;
    for (const Object& object : scene.objects) {
        const MeshView mesh = object.visible ? sources_.meshes(object) : MeshView();
        frame.meshes.push_back(mesh.indices.empty() ? Bounds() : mesh.bounds);
        frame.triangles += std::ssize(mesh.indices) / 3;
    }
    return sources_.programs->ask(std::move(frame));
}

void Viewport::takePrograms(quint64 number) {
    if (number == ordered_.number) {
        ordered_.number = 0;
        if (progress_ == Progress::Waiting) {
            turn_.stop();
            progress_ = Progress::Idle;
            stale_ = true;
            update();
        }
    }
    if (number == prewarmedOrder_) {
        preparePrewarmed();
    }
}

void Viewport::prewarm(const Scene& ahead) {
    if (renderer_ && isVisible() && !inspecting_) {
        prewarmed_.push_back(ahead);
        prewarmedOrder_ = 0;
        prewarming_.start(0);
    }
}

/// How a scene that is prewarmed will be looked at.
View Viewport::viewAhead() const {
    View ahead = view();
    ahead.effects = nullptr;
    return ahead;
}

/// What is drawn goes first; the frame that comes then asks again for what is left.
void Viewport::makePrewarmed() {
    if (!renderer_ || inspecting_ || prewarmed_.empty()) {
        prewarmed_.clear();
        return;
    }
    if (stale_ || isDrawing()) {
        return;
    }
    if (sources_.programs) {
        prewarmedOrder_ = askFor(prewarmed_.back(), viewAhead());
    } else {
        preparePrewarmed();
    }
}

/// Loads what was made elsewhere, so that a frame that needs it does not have to.
void Viewport::preparePrewarmed() {
    prewarmedOrder_ = 0;
    if (!renderer_ || prewarmed_.empty() || stale_ || isDrawing()) {
        return;
    }
    const Scene ahead = std::move(prewarmed_.back());
    prewarmed_.pop_back();
    makeCurrent();
    renderer_->begin(ahead, viewAhead(), sources_.meshes, FramePurpose::Prewarm)
        .step(FrameJob::never);
    doneCurrent();
    watchForRest();
    prewarming_.start(0);
}

} // namespace patina
