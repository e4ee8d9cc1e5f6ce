// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/cost/model_ranking.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>

#include "gl/driver.h"
#include "measure/stability/white_sky_albedo.h"
#include "measure/time/surface_instructions.h"
#include "measure/time/timed_frames.h"
#include "render/surfaces/surface_buffer.h"

namespace patina {
namespace {

using Clock = std::chrono::steady_clock;

constexpr glm::ivec2 sizeOnCpu{256, 256};
constexpr glm::ivec2 sizeOnDevice{1024, 1024};

glm::ivec2 chosenSize(glm::ivec2 wanted) {
    if (wanted.x > 0 && wanted.y > 0) {
        return wanted;
    }
    return gl::isSoftware() ? sizeOnCpu : sizeOnDevice;
}

std::optional<double> lossOf(const Catalog& catalog, const Block& model) {
    const std::optional<double> albedo = whiteSkyAlbedo(catalog, model);
    return albedo ? std::optional(1.0 - *albedo) : std::nullopt;
}

} // namespace

void countFromQuickest(std::vector<ModelCost>& costs) {
    if (costs.empty()) {
        return;
    }
    const ChoiceCost quickest = costs.front().cost;
    for (ModelCost& each : costs) {
        MedianInterval& ratio = each.cost.ratio;
        const double by = quickest.ratio.median;
        if (by > 0.0) {
            ratio = {ratio.median / by, ratio.lower / by, ratio.upper / by};
        }
        each.bound = boundOf(each.cost, quickest);
    }
}

class ModelRanking::Implementation {
  public:
    Implementation(CostSweep::Subject subject, const CostSweep::Options& options,
                   std::unique_ptr<TimedFrames> drawn)
        : subject_(std::move(subject)), options_(options), drawn_(std::move(drawn)),
          models_(subject_.catalog->ofKind(kinds::models)) {
        subject_.scene.ground.mode = GroundMode::Off;
        view_.size = drawn_->size();
        view_.camera = subject_.camera;
        view_.environmentImage = subject_.environment;
        view_.samples = 1;
    }

    void step() {
        if (!hasFrame_) {
            measureFrame();
        } else if (!finished()) {
            pairs_ ? timePair() : beginModel();
        }
    }

    bool finished() const { return costs_.size() == models_.size() || !problems_.empty(); }

    double progress() const {
        const double begun =
            pairs_ ? double(pairs_->cost().runs) / double(options_.pairs.most) : 0.0;
        return finished() ? 1.0 : (double(costs_.size()) + begun) / double(models_.size());
    }

    Turn turn() const {
        const std::size_t index = std::min(costs_.size(), models_.size() - 1);
        return {models_[index]->label, index + 1, models_.size()};
    }

    std::vector<ModelCost> costs() const {
        std::vector<ModelCost> costs = costs_;
        const double milliseconds = medianInterval(firstTimes_).median;
        for (ModelCost& each : costs) {
            each.cost = withTimes(each.cost, {milliseconds, empty_, pixels_});
        }
        std::ranges::stable_sort(costs, [](const ModelCost& a, const ModelCost& b) {
            return a.cost.ratio.median < b.cost.ratio.median;
        });
        countFromQuickest(costs);
        return costs;
    }

    std::string timer() const { return drawn_->method(); }
    std::size_t pixels() const { return pixels_; }
    const Errors& problems() const { return problems_; }

  private:
    Scene sceneOf(const Block& model) const {
        Scene scene = subject_.scene;
        scene.objects[subject_.object].material = defaultMaterial(model);
        return scene;
    }

    /// What is the same for all: how many pixels are shaded, and the frame without them.
    void measureFrame() {
        hasFrame_ = true;
        first_ = sceneOf(*models_.front());
        const auto buffer = drawn_->renderer().captureSurfaces(first_, view_, drawn_->meshes());
        if (!buffer) {
            problems_.push_back(buffer.error());
            return;
        }
        for (std::size_t i = 0; i < buffer->pixels(); ++i) {
            pixels_ += buffer->objectAt(i) == subject_.object ? 1 : 0;
        }
        Scene without = first_;
        without.objects[subject_.object].visible = false;
        std::vector<double> times;
        drawn_->timeOf(without, view_); // this only warms up
        for (int i = 0; i < emptyFrames; ++i) {
            times.push_back(drawn_->timeOf(without, view_));
        }
        empty_ = medianInterval(times);
    }

    void beginModel() {
        other_ = sceneOf(*models_[costs_.size()]);
        drawn_->timeOf(first_, view_); // these only warm up
        drawn_->timeOf(other_, view_);
        pairs_.emplace(options_.pairs, empty_);
        pairsBegan_ = Clock::now();
    }

    /// The model has had its share of the time, and as many pairs as an interval needs.
    bool isLate() const {
        const std::chrono::duration<double> spent = Clock::now() - pairsBegan_;
        return spent.count() > options_.seconds / double(models_.size()) &&
               pairs_->cost().runs >= options_.pairs.fewest;
    }

    void timePair() {
        const double first = drawn_->timeOf(first_, view_);
        const double other = drawn_->timeOf(other_, view_);
        pairs_->add(first, other);
        firstTimes_.push_back(first);
        problems_ = drawn_->problems();
        if ((pairs_->finished() || isLate()) && problems_.empty()) {
            addModel();
        }
    }

    void addModel() {
        const Block& model = *models_[costs_.size()];
        costs_.push_back({model.id, model.label, pairs_->cost(),
                          surfaceInstructions(other_, subject_.object, view_.camera,
                                              {subject_.catalog, subject_.meshes}),
                          lossOf(*subject_.catalog, model)});
        pairs_.reset();
    }

    CostSweep::Subject subject_;
    CostSweep::Options options_;
    std::unique_ptr<TimedFrames> drawn_;
    std::vector<const Block*> models_;
    View view_;
    bool hasFrame_ = false;
    Scene first_;
    Scene other_;
    MedianInterval empty_;
    std::size_t pixels_ = 0;
    std::optional<CostPairs> pairs_;
    Clock::time_point pairsBegan_;
    std::vector<double> firstTimes_;
    std::vector<ModelCost> costs_;
    Errors problems_;
};

ModelRanking::ModelRanking(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}

ModelRanking::~ModelRanking() = default;

Result<std::unique_ptr<ModelRanking>> ModelRanking::create(CostSweep::Subject subject,
                                                           const CostSweep::Options& options) {
    if (subject.object >= subject.scene.objects.size()) {
        return failure("there is no object to measure", "a scene with one");
    }
    auto drawn = TimedFrames::create({subject.catalog, subject.meshes, subject.textures},
                                     chosenSize(options.size), options.programCache);
    if (!drawn) {
        return tl::unexpected(drawn.error());
    }
    return std::unique_ptr<ModelRanking>(new ModelRanking(
        std::make_unique<Implementation>(std::move(subject), options, std::move(*drawn))));
}

void ModelRanking::step() {
    implementation_->step();
}

bool ModelRanking::finished() const {
    return implementation_->finished();
}

double ModelRanking::progress() const {
    return implementation_->progress();
}

ModelRanking::Turn ModelRanking::turn() const {
    return implementation_->turn();
}

std::vector<ModelCost> ModelRanking::costs() const {
    return implementation_->costs();
}

std::string ModelRanking::timer() const {
    return implementation_->timer();
}

std::size_t ModelRanking::pixels() const {
    return implementation_->pixels();
}

const Errors& ModelRanking::problems() const {
    return implementation_->problems();
}

} // namespace patina
