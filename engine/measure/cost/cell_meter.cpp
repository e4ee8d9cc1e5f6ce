// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/cost/cell_meter.h"

#include <chrono>
#include <utility>
#include <vector>

#include "gl/driver.h"
#include "measure/cost/sweep_frames.h"
#include "measure/error/ground_truth_frame.h"
#include "measure/time/median_interval.h"

namespace patina {
namespace {

constexpr glm::ivec2 cellSizeOnCpu{256, 256};
constexpr glm::ivec2 cellSizeOnDevice{1024, 1024};

constexpr int framesOfCell = 7;

/// Is the time of work between two calls of isCancelled.
constexpr std::chrono::milliseconds slice{20};

/// Calls step() of `stepped` until it is done. It is an error where a step fails or it is
/// cancelled.
template <class Stepped>
Result<void> finished(Stepped& stepped, const std::function<bool()>& isCancelled) {
    while (true) {
        const Result<bool> done = stepped.step(slice);
        if (!done) {
            return tl::unexpected(done.error());
        }
        if (*done) {
            return {};
        }
        if (isCancelled && isCancelled()) {
            return failure("it was cancelled");
        }
    }
}

} // namespace

Result<std::unique_ptr<CellMeter>> CellMeter::create(TimedFrames::Supplies supplies,
                                                     std::filesystem::path programCache) {
    auto frames = TimedFrames::create(supplies, gl::isSoftware() ? cellSizeOnCpu : cellSizeOnDevice,
                                      std::move(programCache));
    if (!frames) {
        return tl::unexpected(frames.error());
    }
    return std::unique_ptr<CellMeter>(new CellMeter(std::move(supplies), std::move(*frames)));
}

CellMeter::CellMeter(TimedFrames::Supplies supplies, std::unique_ptr<TimedFrames> frames)
    : supplies_(std::move(supplies)), frames_(std::move(frames)) {}

Result<double> CellMeter::milliseconds(const Subject& subject) {
    View view;
    view.camera = subject.scene.camera;
    view.environmentImage = subject.environment;
    std::vector<double> times;
    for (int i = -1; i < framesOfCell; ++i) {
        const double time = frames_->timeOf(subject.scene, view);
        if (i >= 0) {
            times.push_back(time);
        }
    }
    if (!frames_->problems().empty()) {
        return tl::unexpected(frames_->problems().front());
    }
    return medianInterval(std::move(times)).median;
}

Result<double> CellMeter::error(const Subject& subject, glm::ivec2 size,
                                const std::function<bool()>& isCancelled) {
    const SweepFrames frames({subject.scene, subject.object, subject.scene.camera,
                              frames_->meshes(), supplies_.catalog, supplies_.textures,
                              subject.environment},
                             {}, size);
    GroundTruthFrame truth({frames_->renderer(), frames_->meshes(), frames.of({}),
                            frames.captured({}), frames.counted()});
    if (const auto made = finished(truth, isCancelled); !made) {
        return tl::unexpected(made.error());
    }
    const Material& material = subject.scene.objects[subject.object].material;
    IncrementalCapture capture(frames_->renderer(), frames_->meshes(),
                               frames.captured(levelsOf(material, frames.choices())));
    if (const auto drawn = finished(capture, isCancelled); !drawn) {
        return tl::unexpected(drawn.error());
    }
    return capture.frame().map(
        [&truth](const LinearFrame& frame) { return truth.meter().errorOf(frame).p99; });
}

} // namespace patina
