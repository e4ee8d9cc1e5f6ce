// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/scaling_sweep.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "gl/driver.h"
#include "measure/scaling_scenes.h"
#include "measure/timed_frames.h"

namespace patina {
namespace {

using Axis = ScalingCurve::Axis;
using Clock = std::chrono::steady_clock;

const std::vector<int> edgesOnCpu{64, 96, 128, 192, 256, 384, 512};
const std::vector<int> edgesOnDevice{256, 512, 724, 1024, 1448, 2048};

/// One count of an axis: what is drawn, and how large.
struct Rung {
    double count = 1.0;
    int edge = 256;
    Scene scene;
    std::vector<double> times; ///< milliseconds
};

/// An axis with all its counts.
struct Ladder {
    Axis axis = Axis::Pixels;
    std::vector<Rung> rungs;
};

Ladder pixelLadder(const Scene& scene, const std::vector<int>& edges) {
    Ladder ladder{Axis::Pixels, {}};
    for (const int edge : edges) {
        ladder.rungs.push_back({double(edge) * double(edge), edge, scene, {}});
    }
    return ladder;
}

template <class Make>
Ladder countLadder(Axis axis, const std::vector<int>& counts, int edge, const Make& make) {
    Ladder ladder{axis, {}};
    for (const int count : counts) {
        ladder.rungs.push_back({double(count), edge, make(count), {}});
    }
    return ladder;
}

bool hasLight(const Scene& scene) {
    return std::ranges::any_of(scene.lights, [](const Light& light) { return light.enabled; });
}

} // namespace

class ScalingSweep::Implementation {
  public:
    Implementation(CostSweep::Subject subject, Options options,
                   std::unique_ptr<TimedFrames> drawn)
        : subject_(std::move(subject)), options_(std::move(options)), drawn_(std::move(drawn)) {
        subject_.scene.ground.mode = GroundMode::Off;
        subject_.scene.camera = subject_.camera;
        view_.camera = subject_.camera;
        view_.environmentImage = subject_.environment;
        view_.samples = 1;
        makeLadders();
    }

    void step() {
        if (finished()) {
            return;
        }
        Ladder& ladder = ladders_[ladder_];
        Rung& rung = ladder.rungs[rung_];
        if (drawn_->size().x != rung.edge) {
            drawn_->resize({rung.edge, rung.edge});
            drawn_->timeOf(rung.scene, view_); // makes its buffers
        }
        const double time = drawn_->timeOf(rung.scene, view_);
        problems_ = drawn_->problems();
        if (round_ > 0) { // the first round makes programs
            rung.times.push_back(time);
        }
        ++steps_;
        advance();
    }

    bool finished() const { return ladder_ == ladders_.size() || !problems_.empty(); }

    double progress() const {
        std::size_t all = 0;
        for (const Ladder& ladder : ladders_) {
            all += ladder.rungs.size() * std::size_t(options_.rounds + 1);
        }
        return finished() || all == 0 ? 1.0 : double(steps_) / double(all);
    }

    Turn turn() const {
        const std::size_t index = std::min(ladder_, ladders_.size() - 1);
        return {ladders_[index].axis, index + 1, ladders_.size(), round_, options_.rounds};
    }

    const std::vector<ScalingCurve>& curves() const { return curves_; }
    int rounds() const { return rounds_; }
    std::string timer() const { return drawn_->method(); }
    const Errors& problems() const { return problems_; }

  private:
    void makeLadders() {
        const std::vector<int>& usual = gl::isSoftware() ? edgesOnCpu : edgesOnDevice;
        const Scene& scene = subject_.scene;
        ladders_.push_back(pixelLadder(scene, options_.edges.empty() ? usual : options_.edges));
        if (hasLight(scene)) {
            ladders_.push_back(countLadder(Axis::Lights, options_.lights, options_.edge,
                                           [&](int count) { return withLights(scene, count); }));
        }
        ladders_.push_back(
            countLadder(Axis::Objects, options_.objects, options_.edge, [&](int count) {
                return withCopies(scene, subject_.object, count);
            }));
        std::erase_if(ladders_, [](const Ladder& ladder) { return ladder.rungs.empty(); });
    }

    bool isLate() const {
        const std::chrono::duration<double> spent = Clock::now() - ladderBegan_;
        return round_ > 0 && 3.0 * spent.count() > options_.seconds;
    }

    void advance() {
        if (++rung_ < ladders_[ladder_].rungs.size()) {
            return;
        }
        rung_ = 0;
        if (round_ > 0) {
            tell();
        }
        const bool late = isLate();
        if (++round_ > options_.rounds || late) {
            const int left = options_.rounds + 1 - round_;
            steps_ += std::size_t(left) * ladders_[ladder_].rungs.size();
            round_ = 0;
            ++ladder_;
            ladderBegan_ = Clock::now();
        }
    }

    void tell() {
        ++rounds_;
        const Ladder& ladder = ladders_[ladder_];
        ScalingCurve curve{ladder.axis, {}, std::nullopt};
        for (const Rung& rung : ladder.rungs) {
            curve.samples.push_back(
                {rung.count, medianInterval(rung.times), int(rung.times.size())});
        }
        curve.law = growthLaw(curve.samples);
        if (curves_.size() == ladder_) {
            curves_.emplace_back();
        }
        curves_[ladder_] = std::move(curve);
    }

    CostSweep::Subject subject_;
    Options options_;
    std::unique_ptr<TimedFrames> drawn_;
    View view_;
    std::vector<Ladder> ladders_;
    std::size_t ladder_ = 0;
    int round_ = 0; ///< of the ladder; 0 only warms up
    std::size_t rung_ = 0;
    Clock::time_point ladderBegan_ = Clock::now();
    std::size_t steps_ = 0; ///< that are done, or were left out
    int rounds_ = 0; ///< that were told
    std::vector<ScalingCurve> curves_;
    Errors problems_;
};

ScalingSweep::ScalingSweep(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}

ScalingSweep::~ScalingSweep() = default;

Result<std::unique_ptr<ScalingSweep>> ScalingSweep::create(CostSweep::Subject subject) {
    return create(std::move(subject), Options());
}

Result<std::unique_ptr<ScalingSweep>> ScalingSweep::create(CostSweep::Subject subject,
                                                           Options options) {
    if (subject.object >= subject.scene.objects.size()) {
        return failure("there is no object to measure", "a scene with one");
    }
    auto drawn = TimedFrames::create({subject.catalog, subject.meshes, subject.textures},
                                     {options.edge, options.edge}, options.programCache);
    if (!drawn) {
        return tl::unexpected(drawn.error());
    }
    return std::unique_ptr<ScalingSweep>(new ScalingSweep(std::make_unique<Implementation>(
        std::move(subject), std::move(options), std::move(*drawn))));
}

void ScalingSweep::step() {
    implementation_->step();
}

bool ScalingSweep::finished() const {
    return implementation_->finished();
}

double ScalingSweep::progress() const {
    return implementation_->progress();
}

ScalingSweep::Turn ScalingSweep::turn() const {
    return implementation_->turn();
}

const std::vector<ScalingCurve>& ScalingSweep::curves() const {
    return implementation_->curves();
}

int ScalingSweep::rounds() const {
    return implementation_->rounds();
}

std::string ScalingSweep::timer() const {
    return implementation_->timer();
}

const Errors& ScalingSweep::problems() const {
    return implementation_->problems();
}

} // namespace patina
