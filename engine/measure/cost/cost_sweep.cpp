// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/cost/cost_sweep.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/steps.h"
#include "measure/choice/pass_choices.h"
#include "measure/choice/picture_choices.h"
#include "measure/cost/same_levels.h"
#include "measure/cost/sweep_estimate.h"
#include "measure/cost/sweep_frames.h"
#include "measure/cost/sweep_plan.h"
#include "measure/cost/sweep_size.h"
#include "measure/error/error_baseline.h"
#include "measure/time/paired_frames.h"
#include "measure/time/surface_instructions.h"

namespace patina {
namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

/// Is the share of the time that pairs of single choices may take.
constexpr double shareOfPairs = 0.6;

/// Is the share of the time after which each single choice gets one pair only.
constexpr double shareOfSingles = 0.95;
/// Is the factor of a point's share of the time after which the point ends with the pairs it has.
constexpr double longestShare = 3.0;

/// Is the share of a point's progress that is reached when its frame is drawn.
constexpr double drawnShare = 0.3;

/// Returns the ratio of the exact frame to itself: 1, with the relative spread of its pairs as the
/// noise.
MedianInterval besideItself(const MedianInterval& ratio) {
    return {1.0, std::min(ratio.lower / ratio.median, 1.0),
            std::max(ratio.upper / ratio.median, 1.0)};
}

} // namespace

class CostSweep::Implementation {
  public:
    Implementation(Subject subject, const Options& options, std::unique_ptr<TimedFrames> drawn)
        : options_(options), drawn_(std::move(drawn)),
          frames_(std::move(subject), options, drawn_->size()), plan_({}, false) {
        chart_.choices = frames_.choices();
        chart_.size = drawn_->size();
        chart_.timer = drawn_->method();
        plan_ = SweepPlan(chart_.choices, options.combinations, options.present);
        singles_ = plan_.waiting();
        const auto directions = std::ranges::find_if(chart_.choices, isOfDirections);
        baseline_.emplace(GroundTruthFrame::Wish{drawn_->renderer(), drawn_->meshes(),
                                                 frames_.of({}), frames_.captured({}),
                                                 frames_.counted(), frames_.isOfMaterial()},
                          directions == chart_.choices.end() ? std::string() : directions->id,
                          std::ranges::any_of(chart_.choices, isOfPass));
        run_ = run();
    }

    void step(std::chrono::milliseconds patience) {
        const Clock::time_point began = Clock::now();
        patience_ = patience;
        while (!finished()) {
            run_.step();
            spent_ = Seconds(spentUntilNow_ + (Clock::now() - began)).count();
            if (Clock::now() - began >= patience) {
                break;
            }
        }
        spentUntilNow_ += Clock::now() - began;
    }

    bool finished() const { return run_.isDone(); }

    SweepStep doing() const {
        const std::size_t before = baseline_->steps() + 1; // the last one of empty frames
        SweepStep step{doing_.work,  doing_.levels, before, before + begun_ + plan_.waiting(),
                       doing_.share, secondsInAll_};
        if (finished()) {
            step = {SweepStep::Work::Nothing, {}, step.of, step.of, 1.0, secondsInAll_};
        } else if (doing_.work == SweepStep::Work::Point) {
            step.number = before + begun_;
        } else if (doing_.work != SweepStep::Work::EmptyFrame) {
            step.number = doing_.work == SweepStep::Work::GroundTruthFrame ? 1 : 2;
        }
        return step;
    }

    const CostChart& chart() const { return chart_; }
    const Errors& problems() const { return problems_; }
    const LinearFrame* groundTruth() const {
        return baseline_->isDone() ? &baseline_->groundTruth().meter().groundTruth() : nullptr;
    }

    std::vector<double> errorMap(const ChosenLevels& levels) {
        if (!baseline_->isDone()) {
            return {};
        }
        IncrementalCapture capture(drawn_->renderer(), drawn_->meshes(), frames_.captured(levels));
        Result<bool> drawn = false;
        while (drawn && !*drawn) {
            drawn = capture.step(std::chrono::seconds(1));
        }
        const Result<LinearFrame> frame = drawn ? capture.frame() : tl::unexpected(drawn.error());
        return frame ? baseline_->meterOf(levels).mapOf(*frame) : std::vector<double>();
    }

  private:
    Steps run() {
        secondsInAll_ = secondsOfSingles(frames_, *drawn_);
        co_yield Steps::Pause();
        co_await makeBaseline();
        if (problems_.empty() && !options_.given) {
            co_await timeEmptyFrames();
        }
        while (problems_.empty()) {
            const std::optional<ChosenLevels> levels = nextLevels();
            if (!levels) {
                chart_.leftOut = hasTime() ? 0 : plan_.leftOver(chart_);
                co_return;
            }
            co_await measurePoint(*levels);
        }
    }

    /// Makes the frames with which points are compared.
    Steps makeBaseline() {
        Result<bool> done = baseline_->step(patience_);
        while (done && !*done) {
            const bool isGroundTruth = !baseline_->hasGroundTruth();
            doing_ = {isGroundTruth ? SweepStep::Work::GroundTruthFrame
                                    : SweepStep::Work::ConvergedFrame,
                      {},
                      baseline_->progressOfStep()};
            co_yield Steps::Pause();
            done = baseline_->step(patience_);
        }
        if (!done) {
            problems_.push_back(done.error());
            co_return;
        }
        chart_.pixels = baseline_->groundTruth().pixels();
        chart_.groundTruth = baseline_->groundTruth().method();
        if (std::ranges::any_of(chart_.choices, isOfPass)) {
            chart_.groundTruth += "; ways of picture passes with the finished picture";
        }
        chart_.converged = baseline_->converged();
        if (!frames_.isOfMaterial()) {
            foldLevels();
        }
    }

    void foldLevels() {
        const bool dense = isDense(frames_.subject().scene, frames_.subject().meshes, chart_.size);
        chart_.same = sameSampleLevels(chart_.choices, chart_.size, dense);
        plan_ = SweepPlan(withoutSame(chart_.choices, chart_.same), options_.combinations,
                          chart_.distinct(options_.present));
        singles_ = plan_.waiting();
    }

    /// Times the frame in which nothing of what is measured is shaded, after one that only warms
    /// up.
    Steps timeEmptyFrames() {
        const ChosenFrame frame = frames_.empty();
        drawn_->timeOf(frame.scene, frame.view);
        std::vector<double> times;
        while (times.size() < emptyFrames) {
            doing_ = {SweepStep::Work::EmptyFrame, {}, double(times.size()) / double(emptyFrames)};
            co_yield Steps::Pause();
            times.push_back(drawn_->timeOf(frame.scene, frame.view));
        }
        empty_ = medianInterval(times);
        chart_.emptyMilliseconds = empty_.median;
    }

    bool hasTime() const { return spent_ + longestPoint_ < options_.seconds; }

    /// Returns the next point to measure: no combination that would hardly end in time, and nothing
    /// that is drawn as a measured point.
    std::optional<ChosenLevels> nextLevels() {
        while (begun_ < singles_ || hasTime()) {
            std::optional<ChosenLevels> levels = plan_.next(chart_);
            if (!levels || chart_.find(*levels) == nullptr) {
                return levels;
            }
        }
        return std::nullopt;
    }

    /// Draws the frame of the levels, compares it with the baseline, counts its instructions, and
    /// times it beside the exact one.
    Steps measurePoint(ChosenLevels levels) {
        const double began = spent_;
        CostPoint point{std::move(levels), {}, {}, {}};
        ++begun_;
        if (options_.given && !takeGiven(point)) {
            co_return;
        }
        doing_ = {SweepStep::Work::Point, point.levels, 0.0};
        IncrementalCapture capture(drawn_->renderer(), drawn_->meshes(),
                                   frames_.captured(point.levels));
        std::function<void(double)> report = [this](double done) {
            doing_.share = drawnShare * done;
        };
        Result<LinearFrame> frame;
        co_await draw(std::move(capture), patience_, std::move(report), frame);
        if (!frame) {
            problems_.push_back(frame.error());
            co_return;
        }
        ParallelJob comparing;
        baseline_->meterOf(point.levels).addErrorOf(comparing, *frame, point.error);
        while (!comparing.step(patience_)) {
            co_yield Steps::Pause();
        }
        co_yield Steps::Pause();
        point.instructions = instructionsOf(point.levels);
        if (point.isExact()) {
            exactColors_ = std::move(frame->colors);
        } else if (changesNothing(point, *frame)) {
            fold(std::move(point), began);
            co_return;
        }
        if (!options_.given) {
            co_await timePairs(point);
        }
        if (problems_.empty()) {
            add(std::move(point), began);
        }
    }

    /// Gives the point the cost that is given for it, beside that of the exact one; returns whether
    /// there is one.
    bool takeGiven(CostPoint& point) {
        const std::optional<double> cost = options_.given(point.levels);
        if (point.isExact()) {
            exactCost_ = cost.value_or(0.0);
        }
        if (!(exactCost_ > 0.0)) {
            problems_.push_back(
                {{}, 0, 0, "nothing is predicted of the exact way", "a driver that compiles it"});
            return false;
        }
        const double ratio = cost.value_or(0.0) / exactCost_;
        point.cost.ratio = {ratio, ratio, ratio};
        point.cost.settled = true;
        return cost.has_value();
    }

    std::optional<InstructionCount> instructionsOf(const ChosenLevels& levels) const {
        const Subject& subject = frames_.subject();
        return surfaceInstructions(frames_.of(levels).scene, subject.object, subject.camera,
                                   {subject.catalog, subject.meshes});
    }

    /// Tells whether the levels have no effect on the material: they draw the exact picture bit for
    /// bit, with as many instructions.
    bool changesNothing(const CostPoint& point, const LinearFrame& frame) const {
        const CostPoint* exact = chart_.find({});
        return frames_.isOfMaterial() && exact != nullptr && point.instructions &&
               point.instructions == exact->instructions && frame.colors == exactColors_;
    }

    /// Notes a single level without effect as drawn like the exact one. A combination becomes a
    /// point whose time is the exact one's.
    void fold(CostPoint point, double began) {
        if (point.levels.size() > 1) {
            point.cost.settled = true;
            add(std::move(point), began);
            return;
        }
        const auto& [choice, level] = *point.levels.begin();
        const auto folded = std::ranges::find(chart_.choices, choice, &Choice::id);
        chart_.same.push_back({choice, level, folded->levels.front().id});
    }

    Steps timePairs(CostPoint& point) {
        const ChosenFrame exact = frames_.of({});
        const ChosenFrame frame = frames_.of(point.levels);
        PairedFrames pairs(*drawn_, exact, frame, limits(), empty_);
        while (!pairs.step()) {
            problems_ = drawn_->problems();
            if (!problems_.empty()) {
                co_return;
            }
            doing_.share = drawnShare + (1.0 - drawnShare) * pairs.progress();
            co_yield Steps::Pause();
        }
        problems_ = drawn_->problems();
        const std::vector<double>& times = pairs.exactTimes();
        exactTimes_.insert(exactTimes_.end(), times.begin(), times.end());
        point.cost = pairs.cost();
        if (point.isExact()) {
            point.cost.ratio = besideItself(point.cost.ratio);
        }
    }

    /// Returns the limits of a point's pairs. Single choices share the time that is left, so that
    /// they end in time however slow they are.
    PairedFrames::Limits limits() const {
        const double usual = shareOfPairs * options_.seconds / double(singles_);
        const std::size_t left = begun_ <= singles_ ? singles_ - begun_ + 1 : 1;
        const double mine =
            std::max(shareOfSingles * options_.seconds - spent_, 0.0) / double(left);
        return {options_.pairs, std::min(usual, mine), std::min(longestShare * usual, mine)};
    }

    /// Adds a point and computes the times of all points again, since every pair makes the exact
    /// frame's time more precise.
    void add(CostPoint added, double began) {
        chart_.points.push_back(std::move(added));
        longestPoint_ = std::max(longestPoint_, spent_ - began);
        if (options_.given) {
            return;
        }
        chart_.exactMilliseconds = medianInterval(exactTimes_).median;
        for (CostPoint& point : chart_.points) {
            point.cost = withTimes(point.cost, {chart_.exactMilliseconds, empty_, chart_.pixels});
        }
    }

    /// Describes the current work, its levels, and the share of it that is done.
    struct Doing {
        SweepStep::Work work = SweepStep::Work::GroundTruthFrame;
        ChosenLevels levels;
        double share = 0.0;
    };

    Options options_;
    std::unique_ptr<TimedFrames> drawn_;
    SweepFrames frames_;
    CostChart chart_;
    SweepPlan plan_;
    std::size_t singles_ = 0;
    std::size_t begun_ = 0;     ///< counts points
    double longestPoint_ = 0.0; ///< seconds
    std::optional<ErrorBaseline> baseline_;
    double secondsInAll_ = 0.0;
    MedianInterval empty_; ///< milliseconds of a frame without what is measured
    std::vector<double> exactTimes_;
    double exactCost_ = 0.0;              ///< is what is given for the exact point
    std::vector<glm::dvec3> exactColors_; ///< are those of the exact frame as the device draws it
    Doing doing_;
    std::chrono::milliseconds patience_{}; ///< is the current step's
    Clock::duration spentUntilNow_{};
    double spent_ = 0.0; ///< seconds of work
    Errors problems_;
    Steps run_;
};

CostSweep::CostSweep(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}

CostSweep::~CostSweep() = default;

Result<std::unique_ptr<CostSweep>> CostSweep::create(Subject subject, const Options& options) {
    if (subject.object >= subject.scene.objects.size()) {
        return failure("there is no object to measure", "a scene with one");
    }
    auto drawn = TimedFrames::create({subject.catalog, subject.meshes, subject.textures},
                                     sweepSize(subject, options), options.programCache);
    if (!drawn) {
        return tl::unexpected(drawn.error());
    }
    return std::unique_ptr<CostSweep>(new CostSweep(
        std::make_unique<Implementation>(std::move(subject), options, std::move(*drawn))));
}

void CostSweep::step(std::chrono::milliseconds patience) {
    implementation_->step(patience);
}

bool CostSweep::finished() const {
    return implementation_->finished();
}

SweepStep CostSweep::doing() const {
    return implementation_->doing();
}

double CostSweep::progress() const {
    return doing().progress();
}

const CostChart& CostSweep::chart() const {
    return implementation_->chart();
}

const Errors& CostSweep::problems() const {
    return implementation_->problems();
}

const LinearFrame* CostSweep::groundTruth() const {
    return implementation_->groundTruth();
}

std::vector<double> CostSweep::errorMap(const ChosenLevels& levels) {
    return implementation_->errorMap(levels);
}

} // namespace patina
