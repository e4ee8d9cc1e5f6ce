// SPDX-License-Identifier: GPL-3.0-or-later
// How a view draws a frame: at once, or over several turns with a sketch before it.
#include "viewport/viewport.h"

#include <chrono>
#include <utility>

#include <QLabel>
#include <QOpenGLContext>
#include <QOpenGLFunctions>

#include "render/frame/frame_job.h"
#include "render/gpu/stretched_picture.h"
#include "render/surfaces/inspection_drawer.h"

namespace patina {
namespace {

/// How long a step of a frame may keep the window waiting.
constexpr std::chrono::milliseconds framePatience{20};

/// So long a frame may take that might be a quick one, with the images it is drawn into. What
/// shows it in the window takes some 40 ms more on a slow screen.
constexpr std::chrono::milliseconds firstPatience{40};

/// How long for a sketch. Before the first one there is no window yet that could stand still.
constexpr std::chrono::milliseconds firstSketchPatience{200};
constexpr std::chrono::milliseconds sketchPatience{30};

} // namespace

/// Before the first frame there is nothing yet that could stay on the screen.
void Viewport::showNote() {
    if (frameCount_ == 0) {
        QOpenGLFunctions& gl = *context()->functions();
        const QColor empty = palette().color(QPalette::Dark);
        gl.glBindFramebuffer(GL_FRAMEBUFFER, defaultFramebufferObject());
        gl.glClearColor(empty.redF(), empty.greenF(), empty.blueF(), 1.0f);
        gl.glClear(GL_COLOR_BUFFER_BIT);
    }
    // A note over all of the view would hide it from Qt, which then paints it no more.
    note_->adjustSize();
    note_->move(rect().center() - note_->rect().center());
    note_->show();
}

void Viewport::paintGL() {
    if (!renderer_) {
        return;
    }
    if (resizing_) {
        showLast();
    } else if (progress_ == Progress::Drawn) {
        renderer_->job().show(defaultFramebufferObject());
        std::exchange(sketching_, false) ? finishSketch() : finishFrame();
    } else if (progress_ == Progress::Idle && !capture_ && (stale_ || moreSamples_)) {
        isContinued_ = !std::exchange(stale_, false);
        beginFrame();
    }
}

void Viewport::beginFrame() {
    moreSamples_ = false;
    if (std::exchange(catalogIsNew_, false)) {
        renderer_->setCatalog(catalog_);
    }
    if (inspecting_) {
        timer_->begin();
        renderer_->inspection().draw(sources_.scene(), view(), sources_.meshes,
                                     defaultFramebufferObject());
        finishFrame();
        return;
    }
    const bool isNew = isNew_;
    FrameJob& job = beginJob(isNew ? FramePurpose::Sketch : FramePurpose::Window);
    if (waitsForPrograms(job)) {
        return;
    }
    isNew_ = false;
    timer_->begin();
    if (isNew && drawSketch(job)) {
        return;
    }
    drawFrame(isNew ? beginJob(FramePurpose::Window) : job);
    if (isNew && isDrawing()) {
        showNote();
    }
}

FrameJob& Viewport::beginJob(FramePurpose purpose) {
    return renderer_->begin(sources_.scene(), view(), sources_.meshes, purpose);
}

/// Shows a sketch, now or in later turns. False where the frame is as quick.
bool Viewport::drawSketch(FrameJob& job) {
    const auto patience = frameCount_ == 0 ? firstSketchPatience : sketchPatience;
    sketching_ = job.step(patience) == FrameJob::Progress::More;
    if (job.isNeedless()) {
        return false;
    }
    if (sketching_) {
        goOnWith(Progress::Drawing);
        showNote();
    } else {
        job.show(defaultFramebufferObject());
        finishSketch();
    }
    return true;
}

void Viewport::drawFrame(FrameJob& job) {
    if (job.step(firstPatience) == FrameJob::Progress::More) {
        goOnWith(Progress::Drawing);
    } else {
        job.show(defaultFramebufferObject());
        finishFrame();
    }
}

void Viewport::goOnWith(Progress progress) {
    progress_ = progress;
    turn_.start(0);
}

/// Another turn of a long frame. Where the same objects are seen in another way it is finished
/// before a newer one begins: dropping it for every move of a drag would show none.
void Viewport::proceed() {
    if (progress_ == Progress::Capturing) {
        proceedCapture();
        return;
    }
    if (progress_ == Progress::Waiting) {
        makeTargets();
        return;
    }
    makeCurrent();
    const FrameJob::Progress progress = renderer_->job().step(framePatience);
    doneCurrent();
    if (progress == FrameJob::Progress::Done) {
        progress_ = Progress::Drawn;
        update();
    } else {
        turn_.start(0);
    }
}

/// The whole frame is the next one.
void Viewport::finishSketch() {
    timer_->end();
    progress_ = Progress::Idle;
    note_->hide();
    stale_ = true;
    update();
    Q_EMIT sketchDrawn();
}

void Viewport::finishFrame() {
    timer_->end();
    if (!inspecting_) {
        renderer_->job().noteTime(timer_->milliseconds());
    }
    progress_ = Progress::Idle;
    ++frameCount_;
    note_->hide();
    const FrameReport& report = renderer_->report();
    watchForRest();
    if (report.messages != messages_) {
        messages_ = report.messages;
        Q_EMIT messagesDrawn(messages_);
    }
    probeSoon();
    if (!prewarmed_.empty()) {
        prewarming_.start(0);
    }
    Q_EMIT frameDrawn();
    stale_ = stale_ || report.isWaiting;
    if (stale_) {
        update();
    } else {
        continueSoon();
    }
}

void Viewport::giveUpFrame() {
    turn_.stop();
    const Progress progress = std::exchange(progress_, Progress::Idle);
    if (progress == Progress::Drawing || progress == Progress::Drawn) {
        makeCurrent();
        timer_->end();
        doneCurrent();
    }
    if (progress == Progress::Capturing && capture_) {
        QTimer::singleShot(0, this, &Viewport::beginCapture); // of what there is now
    }
}

} // namespace patina
