// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/approximation/frame_check.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "gl/driver.h"
#include "measure/approximation/written_block.h"
#include "measure/cost/sweep_frames.h"
#include "measure/error/ground_truth_frame.h"
#include "measure/error/incremental_capture.h"
#include "measure/time/timed_frames.h"

namespace patina {
namespace {

using Clock = std::chrono::steady_clock;

constexpr glm::ivec2 comparedSize{64, 64};
constexpr glm::ivec2 timedSizeOnCpu{256, 256};
constexpr glm::ivec2 timedSizeOnDevice{1024, 1024};
constexpr std::chrono::milliseconds stepOfFrames{100};
constexpr double slowFrame = 50.0; ///< milliseconds; slower ones are timed at the compared size
constexpr int minFramePairs = 7;   ///< an interval of 95 % needs 6
constexpr int maxFramePairs = 31;

Error stopped() {
    return failure("it was stopped").value();
}

/// Gives the object's material the block in the place of the one that was searched.
Result<void> setBlock(Scene& scene, std::size_t object, const Block& searched,
                      const std::string& id) {
    Material& material = scene.objects[object].material;
    const BlockValues before =
        searched.kind == kinds::models
            ? material.model
            : (material.part(searched.kind) ? *material.part(searched.kind) : BlockValues{});
    if (before.id != searched.id) {
        return failure("the material has another block in the place of " + searched.label);
    }
    BlockValues next = before;
    next.id = id;
    if (searched.kind == kinds::models) {
        material.model = std::move(next);
    } else {
        setPart(material.parts, searched.kind, std::move(next));
    }
    return {};
}

/// Does steps until they are done.
Result<void> untilDone(auto& work, const std::function<bool()>& isStopped) {
    Result<bool> done = false;
    while (done && !*done) {
        if (isStopped()) {
            return tl::unexpected(stopped());
        }
        done = work.step(stepOfFrames);
    }
    return done ? Result<void>() : tl::unexpected(done.error());
}

/// Draws the frames of one subject.
class FrameCheck {
  public:
    /// `exact` is computed in double precision; `shown` has the block with the found ways.
    FrameCheck(CostSweep::Subject exact, CostSweep::Subject shown, std::string choice,
               TimedFrames& drawn, const std::function<bool()>& isStopped)
        : exact_(std::move(exact), {}, comparedSize), shown_(std::move(shown), {}, comparedSize),
          choice_(std::move(choice)), drawn_(drawn), isStopped_(isStopped) {}

    Result<WaysInFrame> run(std::size_t ways, double seconds) {
        WaysInFrame made;
        made.errorSize = comparedSize;
        made.timer = drawn_.method();
        made.ways.resize(ways);
        if (auto done = compare(made); !done) {
            return tl::unexpected(done.error());
        }
        if (auto done = time(made, seconds); !done) {
            return tl::unexpected(done.error());
        }
        return made;
    }

  private:
    /// Returns the levels of a way; those of the material as it is where `way` is beyond all.
    ChosenLevels levelsOf(std::size_t way, std::size_t ways) const {
        const CostSweep::Subject& subject = shown_.subject();
        ChosenLevels levels =
            patina::levelsOf(subject.scene.objects[subject.object].material, shown_.choices());
        levels.erase(choice_);
        if (way < ways) {
            levels[choice_] = foundLevelId(way);
        }
        return levels;
    }

    Result<void> compare(WaysInFrame& made) {
        GroundTruthFrame truth({drawn_.renderer(), drawn_.meshes(), exact_.of({}),
                                exact_.captured({}), exact_.counted(), true});
        if (auto done = untilDone(truth, isStopped_); !done) {
            return done;
        }
        made.groundTruth = truth.method();
        pixels_ = truth.pixels();
        for (std::size_t i = 0; i < made.ways.size(); ++i) {
            IncrementalCapture capture(drawn_.renderer(), drawn_.meshes(),
                                       shown_.captured(levelsOf(i, made.ways.size())));
            if (auto done = untilDone(capture, isStopped_); !done) {
                return done;
            }
            const auto frame = capture.frame();
            if (!frame) {
                return tl::unexpected(frame.error());
            }
            made.ways[i].error = truth.meter().errorOf(*frame);
        }
        return {};
    }

    MedianInterval emptyTime() {
        const ChosenFrame empty = shown_.empty();
        std::vector<double> times;
        drawn_.timeOf(empty.scene, empty.view); // this only warms up
        for (int i = 0; i < emptyFrames; ++i) {
            times.push_back(drawn_.timeOf(empty.scene, empty.view));
        }
        return medianInterval(std::move(times));
    }

    Result<void> time(WaysInFrame& made, double seconds) {
        const Clock::time_point began = Clock::now();
        const std::size_t count = made.ways.size();
        const ChosenFrame asItIs = shown_.of(levelsOf(count, count));
        drawn_.timeOf(asItIs.scene, asItIs.view); // this makes the program
        if (drawn_.timeOf(asItIs.scene, asItIs.view) > slowFrame) {
            drawn_.resize(comparedSize);
        }
        made.timedSize = drawn_.size();
        const MedianInterval empty = emptyTime();
        std::vector<CostPairs> pairs(count, CostPairs({}, empty));
        std::vector<double> firsts;
        const auto isOver = [&] {
            return std::chrono::duration<double>(Clock::now() - began).count() > seconds;
        };
        for (int round = 0; round <= maxFramePairs && (round <= minFramePairs || !isOver());
             ++round) {
            for (std::size_t i = 0; i < count; ++i) {
                if (isStopped_()) {
                    return tl::unexpected(stopped());
                }
                const ChosenFrame other = shown_.of(levelsOf(i, count));
                const double first = drawn_.timeOf(asItIs.scene, asItIs.view);
                const double second = drawn_.timeOf(other.scene, other.view);
                if (!drawn_.problems().empty()) {
                    return tl::unexpected(drawn_.problems().front());
                }
                if (round > 0) { // the first one only warms up
                    firsts.push_back(first);
                    pairs[i].add(first, second);
                }
            }
        }
        // The compared frames have the same share of pixels.
        const auto area = [](glm::ivec2 size) { return double(size.x) * double(size.y); };
        const double scale = area(made.timedSize) / area(comparedSize);
        const ExactFrame exact{medianInterval(firsts).median, empty,
                               static_cast<std::size_t>(double(pixels_) * scale)};
        made.milliseconds = exact.milliseconds;
        for (std::size_t i = 0; i < count; ++i) {
            made.ways[i].cost = withTimes(pairs[i].cost(), exact);
        }
        return {};
    }

    SweepFrames exact_;
    SweepFrames shown_;
    std::string choice_;
    TimedFrames& drawn_;
    const std::function<bool()>& isStopped_;
    std::size_t pixels_ = 0;
};

} // namespace

Checked<WaysInFrame> waysInFrame(const CostSweep::Subject& subject, const EvalCase& searched,
                                 const CheaperWays& ways, const std::filesystem::path& shaders,
                                 double seconds, const std::function<bool()>& isStopped) {
    const auto written = writtenBlock(searched, ways, shaders);
    if (!written) {
        return tl::unexpected(written.error());
    }
    CostSweep::Subject shown = subject;
    shown.catalog = written->catalog;
    const Block& block = *searched.block.block;
    if (auto set = setBlock(shown.scene, shown.object, block, written->block->id); !set) {
        return tl::unexpected(oneError(set.error()));
    }
    // A block of the user's folder is not among those of double precision.
    CostSweep::Subject exact = written->catalog->find(block.kind, block.id) ? subject : shown;
    exact.catalog = written->catalog;
    const std::vector<Choice> choices =
        materialChoices(shown.scene, shown.object, *written->catalog);
    const auto choice = std::ranges::find(choices, written->choice, &Choice::key);
    if (choice == choices.end()) {
        return tl::unexpected(
            oneError(failure("the material has no use for the ways that were found").value()));
    }
    auto drawn = TimedFrames::create({written->catalog, subject.meshes, subject.textures},
                                     gl::isSoftware() ? timedSizeOnCpu : timedSizeOnDevice, {});
    if (!drawn) {
        return tl::unexpected(oneError(drawn.error()));
    }
    auto made = FrameCheck(std::move(exact), std::move(shown), choice->id, **drawn, isStopped)
                    .run(ways.ways.size(), seconds);
    return made ? Checked<WaysInFrame>(std::move(*made)) : tl::unexpected(oneError(made.error()));
}

} // namespace patina
