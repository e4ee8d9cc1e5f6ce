// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/cost_sweep.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "gl/driver.h"
#include "measure/reference_frame.h"
#include "measure/surface_instructions.h"
#include "measure/sweep_plan.h"
#include "measure/timed_frames.h"

namespace patina {
namespace {

using Clock = std::chrono::steady_clock;

constexpr glm::ivec2 sizeOnCpu{256, 256};
constexpr glm::ivec2 sizeOnDevice{1024, 1024};

/// Of an environment's light, where errors are measured: the same ones in every frame.
constexpr int sampledDirections = 64;

/// Frames without anything to shade, of which the median counts.
constexpr int emptyFrames = 7;

/// The share of the time that pairs of single choices may take.
constexpr double shareOfPairs = 0.6;

glm::ivec2 chosenSize(glm::ivec2 wanted) {
    if (wanted.x > 0 && wanted.y > 0) {
        return wanted;
    }
    return gl::isSoftware() ? sizeOnCpu : sizeOnDevice;
}

LinearFrame linearFrame(const Image& image, double factor) {
    LinearFrame frame;
    frame.size = {image.width, image.height};
    frame.colors.reserve(image.pixels.size() / 4);
    for (std::size_t i = 0; i + 3 < image.pixels.size(); i += 4) {
        const glm::dvec3 color(image.pixels[i], image.pixels[i + 1], image.pixels[i + 2]);
        frame.colors.push_back(color / factor);
    }
    return frame;
}

/// The exact frame takes as long as itself; how far its pairs are apart says what noise there is.
MedianInterval besideItself(const MedianInterval& ratio) {
    return {1.0, std::min(ratio.lower / ratio.median, 1.0),
            std::max(ratio.upper / ratio.median, 1.0)};
}

double seconds(Clock::duration time) {
    return std::chrono::duration<double>(time).count();
}

} // namespace

class CostSweep::Implementation {
  public:
    Implementation(Subject subject, const Options& options, std::unique_ptr<TimedFrames> drawn)
        : subject_(std::move(subject)), options_(options), drawn_(std::move(drawn)),
          curve_(DisplayCurve::of(subject_.scene)), plan_({}, false) {
        subject_.scene.ground.mode = GroundMode::Off;
        const Catalog& catalog = *subject_.catalog;
        subject_.scene.accuracy = PictureAccuracy(); // which has a chart of its own
        chart_.choices = options.scope == Choice::Scope::Material
                             ? materialChoices(subject_.scene, subject_.object, catalog)
                             : choicesOfPicture(subject_.scene, catalog);
        chart_.size = drawn_->size();
        chart_.timer = drawn_->method();
        plan_ = SweepPlan(chart_.choices, options.combinations);
        singles_ = plan_.waiting();
    }

    void step(std::chrono::milliseconds patience) {
        const Clock::time_point began = Clock::now();
        while (!finished()) {
            work(patience);
            spent_ = seconds(spentUntilNow_ + (Clock::now() - began));
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
        const std::size_t measured = chart_.points.size();
        const double known = double(measured + plan_.waiting() + 1);
        const double right = meter_ ? 1.0 : reference_ ? reference_->progress() : 0.0;
        return (right + double(measured)) / (1.0 + known);
    }

    const CostChart& chart() const { return chart_; }
    const Errors& problems() const { return problems_; }
    const LinearFrame* right() const { return meter_ ? &meter_->right() : nullptr; }

    std::vector<double> errorMap(const ChosenLevels& levels) {
        if (!meter_) {
            return {};
        }
        const Result<LinearFrame> frame = captured(levels);
        return frame ? meter_->mapOf(*frame) : std::vector<double>();
    }

  private:
    /// The next piece of work, the smallest there is.
    void work(std::chrono::milliseconds patience) {
        if (!meter_) {
            workOnRight(patience);
        } else if (empties_.size() < emptyFrames) {
            timeEmpty();
        } else if (pairs_) {
            timePair();
        } else {
            beginPoint();
        }
    }

    ChosenFrame frameOf(const ChosenLevels& levels) const {
        ChosenFrame frame{subject_.scene, View()};
        frame.view.size = chart_.size;
        frame.view.camera = subject_.camera;
        frame.view.environmentImage = subject_.environment;
        frame.view.samples = options_.scope == Choice::Scope::Material ? 1 : 0;
        choose(frame, subject_.object, chart_.choices, levels, *subject_.catalog);
        return frame;
    }

    /// The linear frame in whole floats; the picture's own choices say otherwise.
    Result<LinearFrame> captured(const ChosenLevels& levels) {
        ChosenFrame frame = frameOf(levels);
        if (options_.scope == Choice::Scope::Material) {
            frame.view.numbers = HdrNumbers::Full;
            frame.view.environmentSamples = sampledDirections;
        }
        const auto image =
            drawn_->renderer().capture(frame.scene, frame.view, drawn_->meshes(), false);
        if (!image) {
            return tl::unexpected(image.error());
        }
        return linearFrame(*image, curve_.factor());
    }

    void fail(Error error) { problems_.push_back(std::move(error)); }

    void workOnRight(std::chrono::milliseconds patience) {
        if (reference_) {
            if (reference_->step(patience)) {
                takeReference();
            }
            return;
        }
        ChosenFrame frame = frameOf({});
        auto buffer =
            drawn_->renderer().captureSurfaces(frame.scene, frame.view, drawn_->meshes());
        if (!buffer) {
            fail(buffer.error());
            return;
        }
        takeBuffer(std::move(*buffer), measured(frame.scene));
    }

    /// The objects whose shading is measured: those with the material, or all in the picture.
    std::vector<bool> measured(const Scene& scene) const {
        return options_.scope == Choice::Scope::Material
                   ? sharingMaterial(scene, subject_.object)
                   : std::vector<bool>(scene.objects.size(), true);
    }

    /// What does not count is as the device draws it.
    void takeReference() {
        LinearFrame right = reference_->frame();
        reference_.reset();
        const Result<LinearFrame> drawn = captured({});
        if (!drawn) {
            fail(drawn.error());
            return;
        }
        for (std::size_t i = 0; i < right.colors.size(); ++i) {
            if (right.counts[i] == 0) {
                right.colors[i] = drawn->colors[i];
            }
        }
        meter_.emplace(std::move(right), curve_);
    }

    void takeBuffer(SurfaceBuffer buffer, const std::vector<bool>& wanted) {
        std::vector<std::uint8_t> counts(buffer.pixels());
        for (std::size_t i = 0; i < counts.size(); ++i) {
            const std::optional<std::size_t> object = buffer.objectAt(i);
            counts[i] = object && wanted[*object] ? 1 : 0;
            chart_.pixels += counts[i];
        }
        if (chart_.pixels == 0) {
            fail(failure("nothing of the material is in the picture", "an object in view").value());
            return;
        }
        Error reason;
        if (options_.scope == Choice::Scope::Material) {
            auto made = ReferenceFrame::create(std::move(buffer), wanted);
            if (made) {
                reference_ = std::move(*made);
                chart_.right = "the same frame in double precision";
                return;
            }
            reason = made.error();
        }
        compareWithDevice(std::move(counts), reason.problem);
    }

    /// What cannot be computed on the CPU is compared with what the device draws with every choice
    /// exact.
    void compareWithDevice(std::vector<std::uint8_t> counts, const std::string& reason) {
        auto frame = captured({});
        if (!frame) {
            fail(frame.error());
            return;
        }
        frame->counts = std::move(counts);
        chart_.right = reason.empty()
                           ? std::string("the finest frame that the device draws")
                           : fmt::format("the exact frame as the device draws it, because {}",
                                         reason);
        meter_.emplace(std::move(*frame), curve_);
    }

    /// What is left when nothing is shaded of what is measured: other objects take their time in
    /// every frame.
    void timeEmpty() {
        ChosenFrame frame = frameOf({});
        const std::vector<bool> hidden = measured(frame.scene);
        for (std::size_t i = 0; i < hidden.size(); ++i) {
            frame.scene.objects[i].visible = frame.scene.objects[i].visible && !hidden[i];
        }
        if (empties_.empty()) {
            drawn_->timeOf(frame.scene, frame.view); // only warms up
        }
        empties_.push_back(drawn_->timeOf(frame.scene, frame.view));
        chart_.emptyMilliseconds = medianInterval(empties_).median;
    }

    void beginPoint() {
        const bool late = chart_.points.size() >= singles_ && spent_ > options_.seconds;
        std::optional<ChosenLevels> levels = late ? std::nullopt : plan_.next(chart_);
        if (!levels) {
            done_ = true;
            return;
        }
        const Result<LinearFrame> frame = captured(*levels);
        if (!frame) {
            fail(frame.error());
            return;
        }
        point_ = CostPoint{std::move(*levels), meter_->errorOf(*frame), {}, {}};
        exactFrame_ = frameOf({});
        pointFrame_ = frameOf(point_.levels);
        point_.instructions =
            surfaceInstructions(pointFrame_.scene, subject_.object, subject_.camera,
                                {subject_.catalog, subject_.meshes});
        if (point_.isExact()) {
            exactColors_ = frame->colors;
        } else if (changesNothing(*frame)) {
            point_.cost.settled = true;
            addPoint();
            return;
        }
        drawn_->timeOf(exactFrame_.scene, exactFrame_.view); // these only warm up
        drawn_->timeOf(pointFrame_.scene, pointFrame_.view);
        pairs_.emplace(options_.pairs, chart_.emptyMilliseconds);
        pairsBegan_ = Clock::now();
    }

    /// Some levels have nothing to do in a material: they draw the exact picture, bit for bit, with
    /// as many instructions, and take as long.
    bool changesNothing(const LinearFrame& frame) const {
        const CostPoint* exact = chart_.find({});
        return options_.scope == Choice::Scope::Material && exact != nullptr &&
               point_.instructions && point_.instructions == exact->instructions &&
               frame.colors == exactColors_;
    }

    void addPoint() {
        chart_.points.push_back(point_);
        pairs_.reset();
        tellTimes();
    }

    void timePair() {
        const double exact = drawn_->timeOf(exactFrame_.scene, exactFrame_.view);
        const double other = drawn_->timeOf(pointFrame_.scene, pointFrame_.view);
        pairs_->add(exact, other);
        exactTimes_.push_back(exact);
        if (!drawn_->problems().empty()) {
            problems_ = drawn_->problems();
            return;
        }
        const double allowed = shareOfPairs * options_.seconds / double(singles_);
        const bool isLate = seconds(Clock::now() - pairsBegan_) > allowed &&
                            pairs_->cost().runs >= options_.pairs.fewest;
        if (pairs_->finished() || isLate) {
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
            point.cost = withTimes(point.cost, {chart_.exactMilliseconds,
                                                chart_.emptyMilliseconds, chart_.pixels});
        }
    }

    Subject subject_;
    Options options_;
    std::unique_ptr<TimedFrames> drawn_;
    DisplayCurve curve_;
    CostChart chart_;
    SweepPlan plan_;
    std::size_t singles_ = 0;
    std::unique_ptr<ReferenceFrame> reference_; ///< while it is computed
    std::optional<ErrorMeter> meter_;
    std::vector<double> empties_;
    std::vector<double> exactTimes_;
    std::vector<glm::dvec3> exactColors_; ///< as the device draws them
    CostPoint point_; ///< that is measured
    ChosenFrame exactFrame_;
    ChosenFrame pointFrame_;
    std::optional<CostPairs> pairs_;
    Clock::time_point pairsBegan_;
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
                                     chosenSize(options.size), options.programCache);
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
