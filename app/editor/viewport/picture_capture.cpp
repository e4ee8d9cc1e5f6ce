// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/picture_capture.h"

#include <utility>

#include "render/frame/frame_job.h"

namespace patina {

PictureCapture::PictureCapture(FrameLoop& frames, const ViewedScene& viewed)
    : frames_(frames), viewed_(viewed) {
    turn_.setSingleShot(true);
    connect(&turn_, &QTimer::timeout, this, [this] { isBegun_ ? proceed() : begin(); });
    connect(&frames, &FrameLoop::interrupted, this, &PictureCapture::beginAnew);
    connect(&frames, &FrameLoop::closing, this, [this] {
        if (order_) {
            finish({});
        }
    });
}

Image PictureCapture::linearPicture() {
    if (Image shown = frames_.shownPicture(false, 0.0); !shown.pixels.empty()) {
        return shown;
    }
    Scene unexposed = viewed_.sources().scene();
    unexposed.exposure = 0.0;
    return frames_.pictureOf(unexposed, frames_.view(), false);
}

Image PictureCapture::picture(bool display) {
    const Scene& whole = viewed_.sources().whole();
    if (&whole == &viewed_.sources().scene()) {
        return frames_.pictureOf(whole, frames_.view(), display);
    }
    frames_.refresh(); // no samples may be added to this picture
    View wanted = frames_.view();
    wanted.effects = nullptr;
    Image image = frames_.pictureOf(whole, wanted, display);
    frames_.refresh();
    return image;
}

void PictureCapture::start(bool display, Taken taken, SceneChange change) {
    if (order_) {
        finish({}); // a second order ends the first
    }
    order_ = Order{display, std::move(taken), false, std::move(change)};
    begin();
}

void PictureCapture::cancel() {
    if (order_) {
        order_->isAnother = true;
        end();
    }
}

void PictureCapture::begin() {
    const Scene& whole = viewed_.sources().whole();
    const bool isWhole = &whole == &viewed_.sources().scene();
    const bool hasSamples = frames_.samples() > 0;
    const bool isChanged = bool(order_->change);
    if (!frames_.canDraw() || (hasSamples && isWhole && !isChanged && frames_.isUpToDate())) {
        finish(isChanged ? Image() : picture(order_->display)); // none can be drawn, or it is there
        return;
    }
    order_->isAnother = isChanged || !isWhole || hasSamples || !frames_.isUpToDate();
    if (isChanged) {
        order_->changed = order_->change(whole);
    }
    lent_ = &frames_.lend();
    View wanted = frames_.view();
    wanted.effects = isWhole ? wanted.effects : nullptr;
    {
        const ViewContext::Current current(viewed_.sources().context);
        lent_
            ->begin(isChanged ? order_->changed : whole, wanted, viewed_.sources().meshes,
                    FramePurpose::Capture)
            .step(FrameJob::Clock::now());
    }
    isBegun_ = true;
    turn_.start(0);
}

/// Takes the picture in the next turn, of the scene as it is then.
void PictureCapture::beginAnew() {
    isBegun_ = false;
    turn_.start(0);
}

void PictureCapture::proceed() {
    std::optional<Image> picture = proceeded();
    if (picture) {
        finish(std::move(*picture));
    } else {
        turn_.start(0);
    }
}

/// Returns the picture once it is done; an empty one where it cannot be read, and nothing while it
/// is being drawn.
std::optional<Image> PictureCapture::proceeded() {
    const ViewContext::Current current(viewed_.sources().context);
    FrameJob& job = lent_->job();
    if (job.step(FrameLoop::stepPatience) == FrameJob::Progress::More) {
        return std::nullopt;
    }
    return job.read(order_->display).value_or(Image());
}

void PictureCapture::finish(Image picture) {
    const Order done = end();
    done.taken(std::move(picture));
}

PictureCapture::Order PictureCapture::end() {
    Order ended = *std::exchange(order_, std::nullopt);
    turn_.stop();
    isBegun_ = false;
    if (std::exchange(lent_, nullptr) != nullptr) {
        frames_.takeBack(ended.isAnother);
    }
    return ended;
}

} // namespace patina
