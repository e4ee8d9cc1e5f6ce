// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/cost/scaling_sweep.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "core/steps.h"
#include "gl/driver.h"
#include "measure/cost/scaling_scenes.h"
#include "measure/time/timed_frames.h"

namespace patina {
namespace {

using Axis = ScalingCurve::Axis;
using Clock = std::chrono::steady_clock;

const std::vector<int> edgesOnCpu{64, 96, 128, 192, 256, 384, 512};
const std::vector<int> edgesOnDevice{256, 512, 724, 1024, 1448, 2048};

/// Holds one count of an axis: what is drawn, how large, and its times.
struct Rung {
    double count = 1.0;
    int edge = 256; ///< pixels
    Scene scene;
    std::vector<double> times; ///< milliseconds
};

/// Holds an axis with all its counts.
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
    Implementation(CostSweep::Subject subject, Options options, std::unique_ptr<TimedFrames> drawn)
        : subject_(std::move(subject)), options_(std::move(options)), drawn_(std::move(drawn)) {
        subject_.scene.ground.mode = GroundMode::Off;
        subject_.scene.camera = subject_.camera;
        view_.camera = subject_.camera;
        view_.environmentImage = subject_.environment;
        view_.samples = 1;
        makeLadders();
        turn_ = ladders_.empty() ? Turn() : turnOf(0, 0);
        run_ = run();
    }

    void step() { run_.step(); }

    bool finished() const { return run_.isDone(); }

    double progress() const {
        return finished() ? 1.0 : double(frames_) / double(framesOf(ladders_.size()));
    }

    Turn turn() const { return turn_; }

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
            countLadder(Axis::Objects, options_.objects, options_.edge,
                        [&](int count) { return withCopies(scene, subject_.object, count); }));
        std::erase_if(ladders_, [](const Ladder& ladder) { return ladder.rungs.empty(); });
    }

    /// Measures axis after axis, each round after round over all its counts. A step is a frame.
    Steps run() {
        for (std::size_t axis = 0; axis < ladders_.size(); ++axis) {
            const Clock::time_point began = Clock::now();
            for (int round = 0; round <= options_.rounds && !isLate(began, round); ++round) {
                co_await measureRound(axis, round);
                if (!problems_.empty()) {
                    co_return;
                }
            }
            frames_ = framesOf(axis + 1);
        }
    }

    /// Times every count of an axis once. The first round only makes programs.
    Steps measureRound(std::size_t axis, int round) {
        turn_ = turnOf(axis, round);
        for (Rung& rung : ladders_[axis].rungs) {
            const double time = timeOf(rung);
            problems_ = drawn_->problems();
            if (!problems_.empty()) {
                co_return;
            }
            if (round > 0) {
                rung.times.push_back(time);
            }
            ++frames_;
            co_yield Steps::Pause();
        }
        if (round > 0) {
            show(axis);
        }
    }

    Turn turnOf(std::size_t axis, int round) const {
        return {ladders_[axis].axis, axis + 1, ladders_.size(), round, options_.rounds};
    }

    bool isLate(Clock::time_point began, int round) const {
        const std::chrono::duration<double> spent = Clock::now() - began;
        return round > 1 && 3.0 * spent.count() > options_.seconds;
    }

    /// Returns how many frames the first axes have where no round is left out.
    std::size_t framesOf(std::size_t axes) const {
        std::size_t rungs = 0;
        for (std::size_t axis = 0; axis < axes; ++axis) {
            rungs += ladders_[axis].rungs.size();
        }
        return rungs * std::size_t(options_.rounds + 1);
    }

    double timeOf(const Rung& rung) {
        if (drawn_->size().x != rung.edge) {
            drawn_->resize({rung.edge, rung.edge});
            drawn_->timeOf(rung.scene, view_); // makes its buffers
        }
        return drawn_->timeOf(rung.scene, view_);
    }

    /// Computes the curve of an axis from all its times.
    void show(std::size_t axis) {
        ++rounds_;
        const Ladder& ladder = ladders_[axis];
        ScalingCurve curve{ladder.axis, {}, std::nullopt};
        for (const Rung& rung : ladder.rungs) {
            curve.samples.push_back(
                {rung.count, medianInterval(rung.times), int(rung.times.size())});
        }
        curve.law = growthLaw(curve.samples);
        if (curves_.size() == axis) {
            curves_.emplace_back();
        }
        curves_[axis] = std::move(curve);
    }

    CostSweep::Subject subject_;
    Options options_;
    std::unique_ptr<TimedFrames> drawn_;
    View view_;
    std::vector<Ladder> ladders_;
    Turn turn_;
    std::size_t frames_ = 0; ///< counts those that were timed, or left out
    int rounds_ = 0;         ///< counts those that the curves contain
    std::vector<ScalingCurve> curves_;
    Errors problems_;
    Steps run_;
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
