// SPDX-License-Identifier: GPL-3.0-or-later
// How a view draws a picture that is to be kept, over as many turns as it takes.
#include <chrono>
#include <utility>

#include "render/frame/frame_job.h"
#include "viewport/viewport.h"

namespace patina {
namespace {

/// How long a step may keep the window waiting.
constexpr std::chrono::milliseconds capturePatience{20};

} // namespace

void Viewport::capture(bool display, PictureTaken taken) {
    if (capture_) {
        finishCapture({}); // one at a time
    }
    capture_ = Capture{display, std::move(taken)};
    beginCapture();
}

void Viewport::cancelCapture() {
    if (capture_) {
        capture_.reset();
        giveUpFrame();
        refresh();
    }
}

/// Begins, or begins anew where a change has taken the frame's place.
void Viewport::beginCapture() {
    if (!capture_ || progress_ == Progress::Capturing) {
        return;
    }
    const Scene& whole = sources_.whole();
    const bool isWhole = &whole == &sources_.scene();
    const bool hasSamples = samples() > 0;
    if (!renderer_ || (hasSamples && isWhole && isUpToDate())) {
        finishCapture(picture(capture_->display)); // there is none to draw, or it is there
        return;
    }
    capture_->isAnother = !isWhole || hasSamples || !isUpToDate();
    giveUpFrame();
    View wanted = view();
    wanted.effects = isWhole ? wanted.effects : nullptr;
    wanted.isContinued = isContinued_ = false;
    makeCurrent();
    renderer_->begin(whole, wanted, sources_.meshes, FramePurpose::Capture)
        .step(FrameJob::Clock::now());
    doneCurrent();
    goOnWith(Progress::Capturing);
}

void Viewport::proceedCapture() {
    makeCurrent();
    FrameJob& job = renderer_->job();
    const bool isDone = job.step(capturePatience) == FrameJob::Progress::Done;
    Result<Image> picture = isDone ? job.read(capture_->display) : Image();
    doneCurrent();
    if (isDone) {
        finishCapture(picture ? std::move(*picture) : Image());
    } else {
        turn_.start(0);
    }
}

void Viewport::finishCapture(Image picture) {
    const Capture done = std::move(*capture_);
    capture_.reset();
    turn_.stop();
    progress_ = Progress::Idle;
    if (renderer_) {
        watchForRest();
    }
    if (done.isAnother) {
        refresh();
    }
    if (stale_) {
        update();
    }
    done.taken(std::move(picture));
}

} // namespace patina
