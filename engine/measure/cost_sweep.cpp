// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/cost_sweep.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "measure/error_standard.h"
#include "measure/paired_frames.h"
#include "measure/picture_choices.h"
#include "measure/same_levels.h"
#include "measure/surface_instructions.h"
#include "measure/sweep_estimate.h"
#include "measure/sweep_frames.h"
#include "measure/sweep_plan.h"
#include "measure/sweep_size.h"

namespace patina {
namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

/// The share of the time that pairs of single choices may take.
constexpr double shareOfPairs = 0.6;

/// Of the time, after which no single choice has more than one pair: it ends with that.
constexpr double shareOfSingles = 0.95;
/// Times a point's share of the time: with so much it ends, whatever it has.
constexpr double longestShare = 3.0;

/// The share of a point's progress that ends when its frame is drawn.
constexpr double drawnShare = 0.3;

/// The exact frame takes as long as itself; how far its pairs are apart says what noise there is.
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
        standard_.emplace(RightFrame::Wish{drawn_->renderer(), drawn_->meshes(), frames_.of({}),
                                           frames_.captured({}), frames_.counted(),
                                           frames_.isOfMaterial()},
                          directions == chart_.choices.end() ? std::string() : directions->id);
    }

    void step(std::chrono::milliseconds patience) {
        const Clock::time_point began = Clock::now();
        while (!finished()) {
            work(patience);
            spent_ = Seconds(spentUntilNow_ + (Clock::now() - began)).count();
            if (Clock::now() - began >= patience) {
                break;
            }
        }
        spentUntilNow_ += Clock::now() - began;
    }

    bool finished() const { return done_ || !problems_.empty(); }

    SweepStep doing() const {
        SweepStep step = doingNow();
        step.secondsInAll = secondsInAll_;
        return step;
    }

    const CostChart& chart() const { return chart_; }
    const Errors& problems() const { return problems_; }
    const LinearFrame* right() const {
        return standard_->isDone() ? &standard_->right().meter().right() : nullptr;
    }

    std::vector<double> errorMap(const ChosenLevels& levels) {
        if (!standard_->isDone()) {
            return {};
        }
        SlicedCapture capture(drawn_->renderer(), drawn_->meshes(), frames_.captured(levels));
        Result<bool> drawn = false;
        while (drawn && !*drawn) {
            drawn = capture.step(std::chrono::seconds(1));
        }
        const Result<LinearFrame> frame = drawn ? capture.frame() : tl::unexpected(drawn.error());
        return frame ? standard_->meterOf(levels).mapOf(*frame) : std::vector<double>();
    }

  private:
    /// What is done for a point, one after the other.
    enum class Stage { None, Drawing, Comparing, Counting, Timing };

    SweepStep doingNow() const {
        const std::size_t before = standard_->steps() + 1; // the last one of empty frames
        const std::size_t all = before + begun_ + plan_.waiting();
        if (finished()) {
            return {SweepStep::Work::Nothing, {}, all, all, 1.0};
        }
        if (!standard_->isDone()) {
            const bool isRight = !standard_->right().isDone();
            return {isRight ? SweepStep::Work::RightFrame : SweepStep::Work::ConvergedFrame,
                    {}, isRight ? 1u : 2u, all, standard_->progressOfStep()};
        }
        if (empties_.size() < emptyFrames) {
            return {SweepStep::Work::EmptyFrame, {}, before, all,
                    double(empties_.size()) / double(emptyFrames)};
        }
        const auto work = begun_ > 0 ? SweepStep::Work::Point : SweepStep::Work::EmptyFrame;
        return {work, point_.levels, before + begun_, all, shareOfPoint()};
    }

    /// Of the point's work that is done.
    double shareOfPoint() const {
        const double drawn = stage_ == Stage::Drawing ? capture_->progress() : 1.0;
        const double timed = stage_ == Stage::None ? 1.0 : pairs_ ? pairs_->progress() : 0.0;
        return drawnShare * drawn + (1.0 - drawnShare) * timed;
    }

    /// The next piece of work, the smallest there is.
    void work(std::chrono::milliseconds patience) {
        if (!std::exchange(isEstimated_, true)) {
            secondsInAll_ = secondsOfSingles(frames_, *drawn_);
            return;
        }
        if (!standard_->isDone()) {
            workOnStandard(patience);
            return;
        }
        if (empties_.size() < emptyFrames) {
            timeEmpty();
            return;
        }
        switch (stage_) {
        case Stage::None:
            return beginPoint();
        case Stage::Drawing:
            return drawPoint(patience);
        case Stage::Comparing:
            return comparePoint(patience);
        case Stage::Counting:
            return countPoint();
        case Stage::Timing:
            return timeFrame();
        }
    }

    void workOnStandard(std::chrono::milliseconds patience) {
        const Result<bool> done = standard_->step(patience);
        if (!done) {
            problems_.push_back(done.error());
            return;
        }
        chart_.pixels = standard_->right().pixels();
        chart_.right = standard_->right().method();
        chart_.converged = *done ? standard_->converged() : std::nullopt;
        if (*done && !frames_.isOfMaterial()) {
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

    bool hasTime() const { return spent_ + longestPoint_ < options_.seconds; }

    void timeEmpty() {
        const ChosenFrame frame = frames_.empty();
        const double time = drawn_->timeOf(frame.scene, frame.view);
        if (std::exchange(isWarm_, true)) {
            empties_.push_back(time);
            empty_ = medianInterval(empties_);
            chart_.emptyMilliseconds = empty_.median;
        }
    }

    /// No combination is begun that would hardly end in time, and nothing that is known by another
    /// name.
    std::optional<ChosenLevels> nextLevels() {
        while (begun_ < singles_ || hasTime()) {
            std::optional<ChosenLevels> levels = plan_.next(chart_);
            if (!levels || chart_.find(*levels) == nullptr) {
                return levels;
            }
        }
        return std::nullopt;
    }

    void beginPoint() {
        const std::optional<ChosenLevels> levels = nextLevels();
        if (!levels) {
            chart_.leftOut = hasTime() ? 0 : plan_.leftOver(chart_);
            done_ = true;
            return;
        }
        ++begun_;
        pointBegan_ = spent_;
        point_ = CostPoint{*levels, {}, {}, {}};
        exactFrame_ = frames_.of({});
        pointFrame_ = frames_.of(point_.levels);
        capture_.emplace(drawn_->renderer(), drawn_->meshes(), frames_.captured(point_.levels));
        stage_ = Stage::Drawing;
    }

    void drawPoint(std::chrono::milliseconds patience) {
        const Result<bool> drawn = capture_->step(patience);
        if (drawn && !*drawn) {
            return;
        }
        Result<LinearFrame> frame = drawn ? capture_->frame() : tl::unexpected(drawn.error());
        capture_.reset();
        if (!frame) {
            problems_.push_back(frame.error());
            return;
        }
        pointColors_ = std::move(*frame);
        standard_->meterOf(point_.levels).addErrorOf(comparing_, pointColors_, point_.error);
        stage_ = Stage::Comparing;
    }

    void comparePoint(std::chrono::milliseconds patience) {
        if (comparing_.step(patience)) {
            stage_ = Stage::Counting;
        }
    }

    void countPoint() {
        const Subject& subject = frames_.subject();
        point_.instructions = surfaceInstructions(
            pointFrame_.scene, subject.object, subject.camera, {subject.catalog, subject.meshes});
        if (point_.isExact()) {
            exactColors_ = pointColors_.colors;
        } else if (changesNothing()) {
            foldPoint();
            return;
        }
        pairs_.emplace(*drawn_, exactFrame_, pointFrame_, limits(), empty_);
        stage_ = Stage::Timing;
    }

    /// Singles share the time that is left, so that they end in time however slow they are.
    PairedFrames::Limits limits() const {
        const double usual = shareOfPairs * options_.seconds / double(singles_);
        const std::size_t left = begun_ <= singles_ ? singles_ - begun_ + 1 : 1;
        const double mine =
            std::max(shareOfSingles * options_.seconds - spent_, 0.0) / double(left);
        return {options_.pairs, std::min(usual, mine), std::min(longestShare * usual, mine)};
    }

    /// Some levels have nothing to do in a material: they draw the exact picture, bit for bit, with
    /// as many instructions, and take as long.
    bool changesNothing() const {
        const CostPoint* exact = chart_.find({});
        return frames_.isOfMaterial() && exact != nullptr && point_.instructions &&
               point_.instructions == exact->instructions && pointColors_.colors == exactColors_;
    }

    /// A level by itself is the exact one by another name.
    void foldPoint() {
        if (point_.levels.size() > 1) {
            point_.cost.settled = true;
            addPoint();
            return;
        }
        const auto& [choice, level] = *point_.levels.begin();
        const auto folded = std::ranges::find(chart_.choices, choice, &Choice::id);
        chart_.same.push_back({choice, level, folded->levels.front().id});
        stage_ = Stage::None;
    }

    void addPoint() {
        chart_.points.push_back(point_);
        pairs_.reset();
        stage_ = Stage::None;
        longestPoint_ = std::max(longestPoint_, spent_ - pointBegan_);
        tellTimes();
    }

    void timeFrame() {
        const bool isDone = pairs_->step();
        if (!drawn_->problems().empty()) {
            problems_ = drawn_->problems();
            return;
        }
        if (isDone) {
            const std::vector<double>& times = pairs_->exactTimes();
            exactTimes_.insert(exactTimes_.end(), times.begin(), times.end());
            point_.cost = pairs_->cost();
            if (point_.isExact()) {
                point_.cost.ratio = besideItself(point_.cost.ratio);
            }
            addPoint();
        }
    }

    /// All of them anew: every pair says more about the exact frame.
    void tellTimes() {
        chart_.exactMilliseconds = medianInterval(exactTimes_).median;
        for (CostPoint& point : chart_.points) {
            point.cost =
                withTimes(point.cost, {chart_.exactMilliseconds, empty_, chart_.pixels});
        }
    }

    Options options_;
    std::unique_ptr<TimedFrames> drawn_;
    SweepFrames frames_;
    CostChart chart_;
    SweepPlan plan_;
    std::size_t singles_ = 0;
    std::size_t begun_ = 0;       ///< points
    double pointBegan_ = 0.0;     ///< seconds of work before
    double longestPoint_ = 0.0;
    std::optional<ErrorStandard> standard_;
    bool isEstimated_ = false;
    double secondsInAll_ = 0.0;
    bool isWarm_ = false; ///< the frame without what is measured
    std::vector<double> empties_;
    MedianInterval empty_;
    std::vector<double> exactTimes_;
    std::vector<glm::dvec3> exactColors_; ///< as the device draws them
    Stage stage_ = Stage::None;
    CostPoint point_; ///< that is measured
    ChosenFrame exactFrame_;
    ChosenFrame pointFrame_;
    std::optional<SlicedCapture> capture_; ///< while the point is drawn
    LinearFrame pointColors_;
    PieceWork comparing_;
    std::optional<PairedFrames> pairs_; ///< while its frames are timed
    Clock::duration spentUntilNow_{};
    double spent_ = 0.0; ///< seconds of work
    bool done_ = false;
    Errors problems_;
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

const LinearFrame* CostSweep::right() const {
    return implementation_->right();
}

std::vector<double> CostSweep::errorMap(const ChosenLevels& levels) {
    return implementation_->errorMap(levels);
}

} // namespace patina
