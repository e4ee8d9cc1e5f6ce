// SPDX-License-Identifier: GPL-3.0-or-later
// How a view draws a frame: at once, or over several turns with a sketch before it.
#include "viewport/viewport.h"

#include <chrono>
#include <utility>

#include <QLabel>
#include <QOpenGLContext>
#include <QOpenGLFunctions>

#include "render/gpu/stretched_picture.h"

namespace patina {
namespace {

/// How long a step of a frame may keep the window waiting.
constexpr std::chrono::milliseconds framePatience{20};

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
        renderer_->show(defaultFramebufferObject());
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
    if (waitsForPrograms()) {
        return;
    }
    timer_->begin();
    if (inspecting_) {
        renderer_->drawInspection(sources_.scene(), view(), sources_.meshes,
                                  defaultFramebufferObject());
        finishFrame();
        return;
    }
    const bool isNew = std::exchange(isNew_, false);
    const Renderer::Sketch sketch =
        isNew ? renderer_->sketch(sources_.scene(), view(), sources_.meshes,
                                  defaultFramebufferObject(),
                                  frameCount_ == 0 ? firstSketchPatience : sketchPatience)
              : Renderer::Sketch::Needless;
    sketching_ = sketch == Renderer::Sketch::Begun;
    if (sketch == Renderer::Sketch::Shown) {
        finishSketch();
    } else if (!sketching_ && renderer_->drawSmall(sources_.scene(), view(), sources_.meshes,
                                                   defaultFramebufferObject())) {
        finishFrame();
    } else {
        progress_ = Progress::Drawing;
        turn_.start(0);
        if (isNew) {
            showNote();
        }
    }
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
    const bool done = renderer_->proceed(framePatience);
    doneCurrent();
    if (done) {
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
        renderer_->noteTime(timer_->milliseconds());
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
