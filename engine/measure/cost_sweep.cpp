// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/cost_sweep.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "measure/error_standard.h"
#include "measure/measured_scene.h"
#include "measure/paired_frames.h"
#include "measure/picture_choices.h"
#include "measure/same_levels.h"
#include "measure/surface_instructions.h"
#include "measure/sweep_plan.h"
#include "measure/sweep_size.h"

namespace patina {
namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

/// Of an environment's light, where errors of a material are measured: the same ones in every
/// frame, which is too short for a search of the model's lobe, as that depends on the levels.
constexpr int sampledDirections = 4 * Renderer::plainSamples;

/// The share of the time that pairs of single choices may take.
constexpr double shareOfPairs = 0.6;

/// The exact frame takes as long as itself; how far its pairs are apart says what noise there is.
MedianInterval besideItself(const MedianInterval& ratio) {
    return {1.0, std::min(ratio.lower / ratio.median, 1.0),
            std::max(ratio.upper / ratio.median, 1.0)};
}

} // namespace

class CostSweep::Implementation {
  public:
    Implementation(Subject subject, const Options& options, std::unique_ptr<TimedFrames> drawn)
        : subject_(std::move(subject)), options_(options), drawn_(std::move(drawn)),
          plan_({}, false) {
        (isOfMaterial() ? leaveSurfaces : leaveGround)(subject_.scene);
        const Catalog& catalog = *subject_.catalog;
        subject_.scene.accuracy = PictureAccuracy(); // which has a chart of its own
        chart_.choices = isOfMaterial()
                             ? materialChoices(subject_.scene, subject_.object, catalog)
                             : choicesOfPicture(subject_.scene, catalog);
        std::erase_if(chart_.choices, [&options](const Choice& choice) {
            return !options.only.empty() && std::ranges::find(options.only, choice.id) ==
                                                options.only.end();
        });
        chart_.size = drawn_->size();
        chart_.timer = drawn_->method();
        counted_ = isOfMaterial() ? sharingMaterial(subject_.scene, subject_.object)
                                  : std::vector<bool>(subject_.scene.objects.size(), true);
        plan_ = SweepPlan(chart_.choices, options.combinations, options.present);
        singles_ = plan_.waiting();
        const auto directions = std::ranges::find_if(chart_.choices, isOfDirections);
        standard_.emplace(RightFrame::Wish{drawn_->renderer(), drawn_->meshes(), frameOf({}),
                                           capturedFrame({}), counted_, isOfMaterial()},
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

    double progress() const {
        if (finished()) {
            return 1.0;
        }
        const std::size_t measured = begun_;
        const double known = double(measured + plan_.waiting() + 1);
        return (standard_->progress() + double(measured)) / (1.0 + known);
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
        SlicedCapture capture(drawn_->renderer(), drawn_->meshes(), capturedFrame(levels));
        Result<bool> drawn = false;
        while (drawn && !*drawn) {
            drawn = capture.step(std::chrono::seconds(1));
        }
        const Result<LinearFrame> frame =
            drawn ? capture.frame() : tl::unexpected(drawn.error());
        return frame ? standard_->meterOf(levels).mapOf(*frame) : std::vector<double>();
    }

  private:
    /// What is done for a point, one after the other.
    enum class Stage { None, Drawing, Comparing, Counting, Timing };

    bool isOfMaterial() const { return options_.scope == Choice::Scope::Material; }

    /// The next piece of work, the smallest there is.
    void work(std::chrono::milliseconds patience) {
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

    ChosenFrame frameOf(const ChosenLevels& levels) const {
        ChosenFrame frame{subject_.scene, View()};
        frame.view.size = chart_.size;
        frame.view.camera = subject_.camera;
        frame.view.environmentImage = subject_.environment;
        frame.view.samples = isOfMaterial() ? 1 : 0;
        choose(frame, subject_.object, chart_.choices, levels, *subject_.catalog);
        return frame;
    }

    /// As it is captured: in whole floats; the picture's own choices say otherwise.
    ChosenFrame capturedFrame(const ChosenLevels& levels) const {
        ChosenFrame frame = frameOf(levels);
        if (isOfMaterial()) {
            frame.view.numbers = HdrNumbers::Full;
            frame.view.environmentSamples = sampledDirections;
            frame.samplesAtOnce = Renderer::plainSamples;
        }
        return frame;
    }

    void fail(Error error) { problems_.push_back(std::move(error)); }

    void workOnStandard(std::chrono::milliseconds patience) {
        const Result<bool> done = standard_->step(patience);
        if (!done) {
            fail(done.error());
            return;
        }
        chart_.pixels = standard_->right().pixels();
        chart_.right = standard_->right().method();
        chart_.converged = *done ? standard_->converged() : std::nullopt;
        if (*done && !isOfMaterial()) {
            foldLevels();
        }
    }

    void foldLevels() {
        const bool dense = isDense(subject_.scene, subject_.meshes, chart_.size);
        chart_.same = sameSampleLevels(chart_.choices, chart_.size, dense);
        plan_ = SweepPlan(withoutSame(chart_.choices, chart_.same), options_.combinations,
                          chart_.distinct(options_.present));
        singles_ = plan_.waiting();
    }

    /// What is left when nothing of what counts is shaded.
    void timeEmpty() {
        ChosenFrame frame = frameOf({});
        for (std::size_t i = 0; i < counted_.size(); ++i) {
            frame.scene.objects[i].visible = frame.scene.objects[i].visible && !counted_[i];
        }
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
        while (begun_ < singles_ || spent_ + longestPoint_ < options_.seconds) {
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
            done_ = true;
            return;
        }
        ++begun_;
        pointBegan_ = spent_;
        point_ = CostPoint{*levels, {}, {}, {}};
        exactFrame_ = frameOf({});
        pointFrame_ = frameOf(point_.levels);
        capture_.emplace(drawn_->renderer(), drawn_->meshes(), capturedFrame(point_.levels));
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
            fail(frame.error());
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
        point_.instructions =
            surfaceInstructions(pointFrame_.scene, subject_.object, subject_.camera,
                                {subject_.catalog, subject_.meshes});
        if (point_.isExact()) {
            exactColors_ = pointColors_.colors;
        } else if (changesNothing()) {
            foldPoint();
            return;
        }
        const PairedFrames::Limits limits{options_.pairs,
                                          shareOfPairs * options_.seconds / double(singles_)};
        pairs_.emplace(*drawn_, exactFrame_, pointFrame_, limits, empty_);
        stage_ = Stage::Timing;
    }

    /// Some levels have nothing to do in a material: they draw the exact picture, bit for bit, with
    /// as many instructions, and take as long.
    bool changesNothing() const {
        const CostPoint* exact = chart_.find({});
        return isOfMaterial() && exact != nullptr && point_.instructions &&
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

    Subject subject_;
    Options options_;
    std::unique_ptr<TimedFrames> drawn_;
    CostChart chart_;
    SweepPlan plan_;
    std::size_t singles_ = 0;
    std::size_t begun_ = 0;       ///< points
    double pointBegan_ = 0.0;     ///< seconds of work before
    double longestPoint_ = 0.0;
    std::vector<bool> counted_; ///< by object: whose pixels are measured
    std::optional<ErrorStandard> standard_;
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

double CostSweep::progress() const {
    return implementation_->progress();
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
