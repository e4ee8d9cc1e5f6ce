// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/error/ground_truth_frame.h"

#include <utility>

#include <fmt/format.h>

#include "render/frame/frame_job.h"
#include "render/lights/environment_light.h"
#include "render/surfaces/surface_buffer_drawer.h"

namespace patina {

namespace {

/// Are shares of the progress: that of computing in double precision, and that of preparing the
/// meter in the end.
constexpr double computedShare = 0.7;
constexpr double preparedShare = 0.1;

} // namespace

GroundTruthFrame::GroundTruthFrame(Wish wish) : wish_(std::move(wish)), run_(run()) {}

Result<bool> GroundTruthFrame::step(std::chrono::milliseconds patience) {
    patience_ = patience;
    return proceed(run_, problem_);
}

Steps GroundTruthFrame::run() {
    std::optional<LinearFrame> computed;
    co_await compute(computed);
    if (problem_) {
        co_return;
    }
    co_await draw(computed);
}

/// Computes the frame in double precision where that is possible, round after round of an
/// environment's directions, which are those that the device draws. Else `computed` stays empty.
Steps GroundTruthFrame::compute(std::optional<LinearFrame>& computed) {
    std::optional<SurfaceBuffer> buffer = surfaces(0);
    if (buffer) {
        countPixels(*buffer);
    }
    co_yield Steps::Pause();
    const auto frame = problem_ ? nullptr : reference(std::move(*buffer));
    if (!frame) {
        co_return;
    }
    const int directions = frame->isSampled() ? wish_.drawn.view.environmentSamples : 0;
    const int rounds = std::max(directions / EnvironmentLight::roundSamples, 1);
    for (int round = 0; round < rounds; ++round) {
        if (round > 0) {
            buffer = surfaces(round);
            if (!buffer) {
                co_return;
            }
            frame->goOn(std::move(*buffer));
        }
        while (!frame->step(patience_)) {
            progress_ = computedShare * (round + frame->progress()) / rounds;
            co_yield Steps::Pause();
        }
    }
    if (directions > 0) {
        method_ += fmt::format(" and with the same {} directions of the environment per pixel",
                               directions);
    }
    progress_ = computedShare;
    computed = frame->frame();
}

std::optional<SurfaceBuffer> GroundTruthFrame::surfaces(int round) {
    auto buffer =
        wish_.renderer.surfaces().capture(wish_.exact.scene, wish_.exact.view, wish_.meshes, round);
    if (!buffer) {
        problem_ = buffer.error();
        return std::nullopt;
    }
    return std::move(*buffer);
}

void GroundTruthFrame::countPixels(const SurfaceBuffer& buffer) {
    counts_.resize(buffer.pixels());
    for (std::size_t i = 0; i < counts_.size(); ++i) {
        const std::optional<std::size_t> object = buffer.objectAt(i);
        counts_[i] = object && wish_.counted[*object] ? 1 : 0;
        pixels_ += counts_[i];
    }
    if (pixels_ == 0) {
        problem_ =
            failure("nothing of the material is in the picture", "an object in view").value();
    }
}

/// Returns the frame to compute on the CPU; null where that is not possible or not wanted, so that
/// the device's exact frame is the ground truth. Stores in `method_` which it is.
std::unique_ptr<ReferenceFrame> GroundTruthFrame::reference(SurfaceBuffer buffer) {
    method_ = "the finest frame that the device draws";
    if (!wish_.inDoubles) {
        return nullptr;
    }
    const BufferedScene around{wish_.exact.scene, wish_.exact.view, wish_.meshes,
                               *wish_.renderer.catalog()};
    auto made = ReferenceFrame::create(std::move(buffer), wish_.counted, &around);
    method_ = made ? "the same frame in double precision"
                   : fmt::format("the exact frame as the device draws it, because {}",
                                 made.error().problem);
    return made ? std::move(*made) : nullptr;
}

/// Draws the frame on the device, takes the pixels that count from the computed one where there is
/// one, and makes the meter.
Steps GroundTruthFrame::draw(const std::optional<LinearFrame>& computed) {
    const double before = progress_;
    IncrementalCapture capture(wish_.renderer, wish_.meshes, wish_.drawn);
    std::function<void(double)> report = [this, before](double done) {
        progress_ = before + (1.0 - before - preparedShare) * done;
    };
    Result<LinearFrame> drawn;
    co_await patina::draw(std::move(capture), patience_, std::move(report), drawn);
    if (!drawn) {
        problem_ = drawn.error();
        co_return;
    }
    const int directions = wish_.renderer.job().environmentSamples();
    if (!computed && directions > 0) {
        method_ = fmt::format("{}, with the same {} directions of the environment per pixel",
                              method_, directions);
    }
    for (std::size_t i = 0; computed && i < counts_.size(); ++i) {
        if (counts_[i] != 0) {
            drawn->colors[i] = computed->colors[i];
        }
    }
    drawn->counts = std::move(counts_);
    ParallelJob preparing;
    const DisplayCurve curve = wish_.drawn.isFinished // its light is exposed and tone mapped
                                   ? DisplayCurve()
                                   : DisplayCurve::of(wish_.exact.scene, *wish_.renderer.catalog());
    meter_.emplace(std::move(*drawn), curve, preparing);
    while (!preparing.step(patience_)) {
        co_yield Steps::Pause();
    }
}

} // namespace patina
