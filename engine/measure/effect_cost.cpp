// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/effect_cost.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include <glm/common.hpp>

#include "gl/driver.h"
#include "measure/timed_frames.h"

namespace patina {
namespace {

constexpr glm::ivec2 effectSizeOnCpu{256, 256};
constexpr glm::ivec2 effectSizeOnDevice{1024, 1024};

/// The first round compiles and lets the driver prepare; its times count for nothing.
constexpr int warmUpRounds = 1;

/// Smaller frames say little of larger ones.
constexpr glm::ivec2 leastSize{64, 64};

/// An interval of 95 % needs 6 samples.
constexpr int leastRounds = 7;

glm::ivec2 effectSize(glm::ivec2 wanted) {
    if (wanted.x > 0 && wanted.y > 0) {
        return wanted;
    }
    return gl::isSoftware() ? effectSizeOnCpu : effectSizeOnDevice;
}

} // namespace

class EffectCostMeter::Implementation {
  public:
    Implementation(Subject subject, const Options& options, std::unique_ptr<TimedFrames> drawn)
        : subject_(std::move(subject)), rounds_(options.rounds + warmUpRounds),
          seconds_(options.seconds), mayShrink_(options.mayShrink), drawn_(std::move(drawn)) {
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
    }

    void step() {
        if (finished()) {
            return;
        }
        if (done_ == 0 && mayShrink_) {
            shrink();
        }
        const bool counts = done_ >= warmUpRounds * perRound();
        const auto began = Clock::now();
        const double with = drawn_->timeOf(subject_.scene, view_);
        if (counts) {
            frames_.push_back(with);
        }
        if (!tests_.empty()) {
            Test& test = tests_[static_cast<std::size_t>(done_) % tests_.size()];
            const double without = drawn_->timeOf(test.scene, view_);
            if (counts) {
                test.differences.push_back(with - without);
            }
        }
        ++done_;
        if (counts) {
            counted_ += Clock::now() - began;
        }
        if (done_ == (warmUpRounds + 1) * perRound()) {
            fitRounds();
        }
    }

    bool finished() const { return done_ >= total() || !drawn_->problems().empty(); }
    double progress() const { return finished() ? 1.0 : double(done_) / total(); }

    EffectCosts costs() const {
        EffectCosts costs;
        costs.frame = medianInterval(frames_);
        for (const Test& test : tests_) {
            if (!test.differences.empty()) {
                costs.effects.push_back({test.effect, medianInterval(test.differences)});
            }
        }
        costs.rest = costs.frame.median - sumOf(costs, subject_.rows);
        costs.size = drawn_->size();
        costs.pairs = static_cast<int>(frames_.size()) / perRound();
        costs.method = drawn_->method();
        costs.problems = drawn_->problems();
        return costs;
    }

  private:
    /// An effect that is measured, and the scene without it.
    struct Test {
        std::string effect;
        Scene scene;
        std::vector<double> differences; ///< milliseconds
    };

    using Clock = std::chrono::steady_clock;

    int perRound() const { return std::max(static_cast<int>(tests_.size()), 1); }
    int total() const { return rounds_ * perRound(); }

    /// So small that the fewest rounds end in time: a frame takes about as long as it has pixels.
    /// The first one, which compiles, tells nothing.
    void shrink() {
        drawn_->timeOf(subject_.scene, view_);
        const double frame = drawn_->timeOf(subject_.scene, view_) / 1000.0;
        const double all = 2.0 * frame * perRound() * std::min(rounds_, leastRounds + warmUpRounds);
        if (all > seconds_) {
            const glm::dvec2 size = std::sqrt(seconds_ / all) * glm::dvec2(drawn_->size());
            drawn_->resize(glm::min(drawn_->size(), glm::max(glm::ivec2(size), leastSize)));
        }
    }

    /// As many rounds as there is time for, now that one was timed.
    void fitRounds() {
        const double round = std::max(std::chrono::duration<double>(counted_).count(), 1e-6);
        const double most = std::min(seconds_ / round, 1e6);
        rounds_ = std::min(rounds_, warmUpRounds + std::max(static_cast<int>(most), leastRounds));
    }

    Subject subject_;
    int rounds_;
    double seconds_;
    bool mayShrink_;
    int done_ = 0;
    Clock::duration counted_{}; ///< what the rounds took that count
    std::unique_ptr<TimedFrames> drawn_;
    View view_;
    std::vector<Test> tests_;
    std::vector<double> frames_; ///< milliseconds of frames with everything
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

double sumOf(const EffectCosts& costs, const std::vector<EffectRow>& rows) {
    double sum = 0.0;
    for (const EffectRow& row : rows) {
        const EffectCost* cost = row.within.empty() ? costs.of(row.line.effect) : nullptr;
        sum += cost == nullptr || cost->belowNoise() ? 0.0 : cost->milliseconds.median;
    }
    return sum;
}

} // namespace patina
