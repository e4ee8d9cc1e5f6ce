// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/error/incremental_capture.h"

#include <algorithm>
#include <utility>

#include "core/color.h"
#include "core/exposure.h"
#include "render/frame/frame_job.h"

namespace patina {

IncrementalCapture::IncrementalCapture(Renderer& renderer, const MeshSource& meshes,
                                       ChosenFrame frame)
    : renderer_(renderer), meshes_(meshes), frame_(std::move(frame)) {}

void IncrementalCapture::begin() {
    View part = frame_.view;
    part.isContinued = continued_;
    if (continued_) {
        part.environmentSamples = frame_.view.environmentSamples - samples();
    }
    if (frame_.samplesAtOnce > 0) {
        part.environmentSamples = std::min(part.environmentSamples, frame_.samplesAtOnce);
    }
    renderer_.begin(frame_.scene, part, meshes_, FramePurpose::Capture);
}

int IncrementalCapture::samples() const {
    return renderer_.job().environmentSamples();
}

/// Tells whether another frame must add samples of an environment, since one frame has only so
/// many.
bool IncrementalCapture::needsSamples() const {
    return samples() > 0 && samples() < frame_.view.environmentSamples;
}

Result<bool> IncrementalCapture::step(std::chrono::milliseconds patience) {
    if (!begun_) {
        begin();
        begun_ = true;
    }
    FrameJob& job = renderer_.job();
    if (job.step(patience) == FrameJob::Progress::More) {
        return false;
    }
    if (job.failure()) {
        return tl::unexpected(*job.failure());
    }
    if (needsSamples()) {
        begun_ = false;
        continued_ = true;
        return false;
    }
    isDone_ = true;
    return true;
}

double IncrementalCapture::progress() const {
    const int wanted = frame_.view.environmentSamples;
    const int drawn = continued_ ? samples() : 0;
    return isDone_ ? 1.0 : wanted > 0 ? std::min(double(drawn) / wanted, 1.0) : 0.0;
}

Result<LinearFrame> IncrementalCapture::frame() const {
    const auto image = renderer_.job().read(frame_.isFinished);
    if (!image) {
        return tl::unexpected(image.error());
    }
    const double factor = exposureFactor(frame_.scene.exposure);
    const auto light = [this, factor](const glm::dvec3& color) {
        return frame_.isFinished ? srgbDecoded(color) : color / factor;
    };
    LinearFrame frame;
    frame.size = {image->width, image->height};
    frame.colors.reserve(image->pixels.size() / 4);
    for (std::size_t i = 0; i + 3 < image->pixels.size(); i += 4) {
        const glm::dvec3 color(image->pixels[i], image->pixels[i + 1], image->pixels[i + 2]);
        frame.colors.push_back(light(color));
    }
    return frame;
}

Result<bool> proceed(Steps& run, const std::optional<Error>& problem) {
    run.step();
    return problem ? Result<bool>(tl::unexpected(*problem)) : run.isDone();
}

Steps draw(IncrementalCapture capture, const std::chrono::milliseconds& patience,
           std::function<void(double)> report, Result<LinearFrame>& drawn) {
    Result<bool> done = capture.step(patience);
    while (done && !*done) {
        report(capture.progress());
        co_yield Steps::Pause();
        done = capture.step(patience);
    }
    report(1.0);
    drawn = done ? capture.frame() : tl::unexpected(done.error());
    co_yield Steps::Pause();
}

} // namespace patina
