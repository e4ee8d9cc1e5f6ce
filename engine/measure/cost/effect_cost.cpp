// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/cost/effect_cost.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include <glm/common.hpp>

#include "core/steps.h"
#include "gl/driver.h"
#include "measure/time/timed_frames.h"

namespace patina {
namespace {

constexpr glm::ivec2 effectSizeOnCpu{256, 256};
constexpr glm::ivec2 effectSizeOnDevice{1024, 1024};

/// Is the edge of the first frames, pixels: they compile and let the driver prepare, for which
/// small ones are enough.
constexpr int warmUpEdge = 16;

/// Is the least edge of a timed frame, pixels: smaller frames say little about larger ones.
constexpr int minEdge = 64;

/// Is the least number of rounds; an interval of 95 % needs 6 samples.
constexpr int minRounds = 7;

/// Is the number of frames whose passes are timed, if there is time for so many; an interval of
/// 95 % needs 6.
constexpr int framesOfPasses = 7;

/// Is the share of the time that they may take.
constexpr double maxOfPasses = 0.2;

/// Is how far objects move between two of them, in metres, so that shadow maps are drawn anew.
constexpr double passShift = 1e-4;

/// Is the factor of the edge below which a larger size is not worth another trial.
constexpr double minGrowth = 1.2;

/// Is the share of the time that warming up may take.
constexpr double maxOfWarmUp = 0.5;

glm::ivec2 effectSize(glm::ivec2 wanted) {
    if (wanted.x > 0 && wanted.y > 0) {
        return wanted;
    }
    return gl::isSoftware() ? effectSizeOnCpu : effectSizeOnDevice;
}

/// Returns a size of the same shape with this shorter edge; no smaller than one pixel, and no
/// larger than `size`.
glm::ivec2 withShortEdge(glm::ivec2 size, double edge) {
    const double part = std::min(1.0, edge / std::min(size.x, size.y));
    return glm::max(glm::ivec2(part * glm::dvec2(size)), glm::ivec2(1));
}

} // namespace

class EffectCostMeter::Implementation {
  public:
    Implementation(Subject subject, const Options& options, std::unique_ptr<TimedFrames> drawn)
        : subject_(std::move(subject)), rounds_(options.rounds), seconds_(options.seconds),
          mayShrink_(options.mayShrink), drawn_(std::move(drawn)), size_(drawn_->size()) {
        view_.camera = subject_.camera;
        view_.environmentImage = subject_.environment;
        for (const EffectRow& row : subject_.rows) {
            if (row.in && row.removable) {
                tests_.push_back(
                    {row.line.effect,
                     withoutEffects(subject_.scene, {&row.line.effect, 1}, *subject_.catalog),
                     {}});
            }
        }
        ready_ = tests_.size();
        run_ = run();
    }

    void step() { run_.step(); }

    bool finished() const { return run_.isDone(); }

    double progress() const {
        const double all = warmUpFrames() + framesOfPasses + rounds_ * perRound();
        const double done = warm_ + static_cast<double>(passes_.size()) + pairs();
        const double share = std::max(done / all, spent_ / std::max(seconds_, 1e-6));
        return finished() ? 1.0 : std::min(share, 1.0);
    }

    EffectCosts costs() const {
        EffectCosts costs;
        costs.frame = medianInterval(frames_);
        costs.pairs = pairs() / perRound();
        for (const Test& test : tests_) {
            const int pairs = static_cast<int>(test.differences.size());
            if (pairs > 0) {
                costs.effects.push_back({test.effect, medianInterval(test.differences), pairs});
            }
            if (pairs == 0 || !costs.effects.back().isSure()) {
                costs.secondsNeeded = secondsForAll();
            }
            costs.pairs = std::min(costs.pairs, pairs);
        }
        costs.rest = costs.frame.median - sumOf(costs, subject_.rows);
        costs.passes = passCosts();
        costs.size = drawn_->size();
        costs.method = drawn_->method();
        costs.problems = drawn_->problems();
        return costs;
    }

  private:
    /// Holds an effect that is measured, and the scene without it.
    struct Test {
        std::string effect;
        Scene scene;
        std::vector<double> differences; ///< milliseconds
    };

    using Clock = std::chrono::steady_clock;

    int perRound() const { return std::max(static_cast<int>(ready_), 1); }
    int warmUpFrames() const { return 1 + static_cast<int>(ready_); }
    int pairs() const { return static_cast<int>(frames_.size()); }

    /// Returns the milliseconds of a frame. The seconds that drawing it takes in all, up to
    /// `maxSeconds`, count as spent.
    double timeOf(const Scene& scene, double maxSeconds = std::numeric_limits<double>::infinity()) {
        const auto began = Clock::now();
        const double time = drawn_->timeOf(scene, view_);
        last_ = std::chrono::duration<double>(Clock::now() - began).count();
        spent_ += std::min(last_, maxSeconds);
        return time;
    }

    Steps run() {
        co_await warmUp();
        chooseSize();
        co_yield Steps::Pause();
        co_await timePasses();
        while (!isOver()) {
            addPair();
            co_yield Steps::Pause();
        }
    }

    bool isOver() const {
        const bool isLate = !frames_.empty() && spent_ + secondsOfPair() > seconds_;
        return isLate || pairs() >= rounds_ * perRound() || !drawn_->problems().empty();
    }

    /// Draws small frames, which make all programs: the complete one, then one without each effect
    /// while there is time for it.
    Steps warmUp() {
        drawn_->resize(withShortEdge(size_, warmUpEdge));
        timeOf(subject_.scene, 0.0);
        timeOf(subject_.scene);
        const double warmFrame = last_; // of a frame that compiles nothing
        for (warm_ = 1; warm_ < warmUpFrames(); ++warm_) {
            co_yield Steps::Pause();
            timeOf(tests_[static_cast<std::size_t>(warm_) - 1].scene, warmFrame);
            if (spent_ > maxOfWarmUp * seconds_) {
                ready_ = static_cast<std::size_t>(warm_);
            }
        }
    }

    /// Chooses the size that is wanted or, where frames may shrink, the largest with which the
    /// fewest rounds end in time, if the time grows with the pixels. It draws a frame of that size,
    /// so that the driver has prepared for it.
    void chooseSize() {
        glm::ivec2 size = mayShrink_ ? withShortEdge(size_, minEdge) : size_;
        for (double growth = 2.0; growth > minGrowth;) {
            drawn_->resize(size);
            timeOf(subject_.scene);
            if (size == size_) {
                return;
            }
            timeOf(subject_.scene);
            const double all = 2.0 * last_ * perRound() * (minRounds + 1);
            growth = std::sqrt(std::max(seconds_ - spent_, 0.0) / all);
            const glm::ivec2 larger = withShortEdge(size_, growth * std::min(size.x, size.y));
            size = growth > minGrowth ? larger : size;
        }
    }

    /// Times the passes of frames in which all objects have moved a little.
    Steps timePasses() {
        Scene moved = subject_.scene;
        for (Object& object : moved.objects) {
            object.translation.x += passShift;
        }
        const double end = spent_ + maxOfPasses * seconds_;
        const auto isInTime = [&] { return spent_ + last_ < end && drawn_->problems().empty(); };
        if (isInTime()) {
            passesOf(moved); // the driver prepares for shadow maps
        }
        for (int i = 0; i < framesOfPasses && isInTime(); ++i) {
            passes_.push_back(passesOf(i % 2 == 0 ? subject_.scene : moved));
            co_yield Steps::Pause();
        }
    }

    std::vector<PassStopwatch::Lap> passesOf(const Scene& scene) {
        const auto began = Clock::now();
        std::vector<PassStopwatch::Lap> laps = drawn_->passesOf(scene, view_);
        last_ = std::chrono::duration<double>(Clock::now() - began).count();
        spent_ += last_;
        return laps;
    }

    std::vector<PassCost> passCosts() const {
        std::vector<PassCost> costs;
        for (std::size_t i = 0; !passes_.empty() && i < passes_.front().size(); ++i) {
            const std::string_view name = passes_.front()[i].pass;
            std::vector<double> times;
            for (const auto& laps : passes_) {
                const auto lap = std::ranges::find(laps, name, &PassStopwatch::Lap::pass);
                times.push_back(lap == laps.end() ? 0.0 : lap->milliseconds);
            }
            costs.push_back({std::string(name), medianInterval(std::move(times)),
                             static_cast<int>(passes_.size())});
        }
        return costs;
    }

    void addPair() {
        const double before = spent_;
        const double with = timeOf(subject_.scene);
        if (!tests_.empty()) {
            Test& test = tests_[frames_.size() % ready_];
            test.differences.push_back(with - timeOf(test.scene));
        }
        frames_.push_back(with);
        counted_ += spent_ - before;
    }

    double secondsOfPair() const { return frames_.empty() ? 0.0 : counted_ / pairs(); }

    /// Returns the seconds that the fewest pairs of every effect take, with all that is no pair.
    double secondsForAll() const {
        const auto minPairs = static_cast<double>(minRounds * tests_.size());
        return spent_ - counted_ + minPairs * secondsOfPair();
    }

    Subject subject_;
    int rounds_;
    double seconds_;
    bool mayShrink_;
    std::unique_ptr<TimedFrames> drawn_;
    glm::ivec2 size_;
    int warm_ = 0;         ///< counts small frames that were drawn
    double last_ = 0.0;    ///< seconds that the newest frame took in all
    double spent_ = 0.0;   ///< seconds
    double counted_ = 0.0; ///< seconds of spent_ that pairs took
    View view_;
    std::vector<Test> tests_;
    std::size_t ready_ = 0;      ///< counts the first tests, which are measured
    std::vector<double> frames_; ///< milliseconds of frames with everything
    std::vector<std::vector<PassStopwatch::Lap>> passes_; ///< are those of some frames
    Steps run_;
};

EffectCostMeter::EffectCostMeter(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}

EffectCostMeter::~EffectCostMeter() = default;

Result<std::unique_ptr<EffectCostMeter>> EffectCostMeter::create(Subject subject,
                                                                 const Options& options) {
    auto drawn = TimedFrames::create({subject.catalog, subject.meshes, subject.textures},
                                     effectSize(options.size), options.programCache);
    if (!drawn) {
        return tl::unexpected(drawn.error());
    }
    return std::unique_ptr<EffectCostMeter>(new EffectCostMeter(
        std::make_unique<Implementation>(std::move(subject), options, std::move(*drawn))));
}

void EffectCostMeter::step() {
    implementation_->step();
}

bool EffectCostMeter::finished() const {
    return implementation_->finished();
}

double EffectCostMeter::progress() const {
    return implementation_->progress();
}

EffectCosts EffectCostMeter::costs() const {
    return implementation_->costs();
}

const EffectCost* EffectCosts::of(std::string_view effect) const {
    const auto found =
        std::find_if(effects.begin(), effects.end(),
                     [effect](const EffectCost& cost) { return cost.effect == effect; });
    return found == effects.end() ? nullptr : &*found;
}

double EffectCosts::ofAllPasses() const {
    double all = 0.0;
    for (const PassCost& cost : passes) {
        all += cost.milliseconds.median;
    }
    return all;
}

std::vector<PassCost> EffectCosts::visiblePasses() const {
    constexpr double minShare = 1e-3;
    const double all = ofAllPasses();
    std::vector<PassCost> visible;
    std::ranges::copy_if(passes, std::back_inserter(visible), [all](const PassCost& cost) {
        return cost.milliseconds.median >= minShare * all;
    });
    return visible;
}

double sumOf(const EffectCosts& costs, const std::vector<EffectRow>& rows) {
    double sum = 0.0;
    for (const EffectRow& row : rows) {
        const EffectCost* cost = row.within.empty() ? costs.of(row.line.effect) : nullptr;
        sum += cost == nullptr || cost->belowNoise() ? 0.0 : cost->milliseconds.median;
    }
    return sum;
}

} // namespace patina
