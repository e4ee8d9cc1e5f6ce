// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/cost/model_ranking.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>

#include "core/steps.h"
#include "gl/driver.h"
#include "measure/stability/white_sky_albedo.h"
#include "measure/time/surface_instructions.h"
#include "measure/time/timed_frames.h"
#include "render/surfaces/surface_buffer_drawer.h"

namespace patina {
namespace {

using Clock = std::chrono::steady_clock;

constexpr glm::ivec2 rankedSizeOnCpu{256, 256};
constexpr glm::ivec2 rankedSizeOnDevice{1024, 1024};

glm::ivec2 chosenSize(glm::ivec2 wanted) {
    if (wanted.x > 0 && wanted.y > 0) {
        return wanted;
    }
    return gl::isSoftware() ? rankedSizeOnCpu : rankedSizeOnDevice;
}

/// Is the number of pairs of a model in each round. It is small, so that other load of the machine,
/// perhaps for minutes, affects all models and shows in each one's interval.
constexpr int pairsPerTurn = 2;
constexpr int minTurns = 6;

/// Returns the quotient of two numbers with intervals; the first number where the second may be 0.
MedianInterval quotient(const MedianInterval& a, const MedianInterval& b) {
    return b.lower > 0.0 ? MedianInterval{a.median / b.median, a.lower / b.upper, a.upper / b.lower}
                         : a;
}

std::optional<double> lossOf(const Catalog& catalog, const Block& model) {
    const std::optional<double> albedo = whiteSkyAlbedo(catalog, model);
    return albedo ? std::optional(1.0 - *albedo) : std::nullopt;
}

/// Returns the materials whose model is known; every model with its defaults where none is given.
std::vector<Material> rankedMaterials(std::vector<Material> given, const Catalog& catalog) {
    if (given.empty()) {
        for (const Block* model : catalog.ofKind(kinds::models)) {
            given.push_back(defaultMaterial(*model));
        }
    }
    std::erase_if(given, [&catalog](const Material& each) {
        return catalog.find(kinds::models, each.model.id) == nullptr;
    });
    return given;
}

} // namespace

void countFromQuickest(std::vector<ModelCost>& costs) {
    if (costs.empty()) {
        return;
    }
    const ChoiceCost quickest = costs.front().cost;
    for (ModelCost& each : costs) {
        each.cost.ratio = quotient(each.cost.ratio, quickest.ratio);
        each.bound = boundOf(each.cost, quickest);
    }
    costs.front().cost.ratio = {1.0, 1.0, 1.0};
}

class ModelRanking::Implementation {
  public:
    Implementation(CostSweep::Subject subject, const CostSweep::Options& options,
                   std::unique_ptr<TimedFrames> drawn, std::vector<Material> materials)
        : subject_(std::move(subject)), options_(options), drawn_(std::move(drawn)),
          materials_(std::move(materials)) {
        for (const Material& material : materials_) {
            models_.push_back(subject_.catalog->find(kinds::models, material.model.id));
        }
        subject_.scene.ground.mode = GroundMode::Off;
        view_.size = drawn_->size();
        view_.camera = subject_.camera;
        view_.environmentImage = subject_.environment;
        view_.samples = 1;
        run_ = run();
    }

    void step() { run_.step(); }

    bool finished() const { return run_.isDone(); }

    double progress() const {
        constexpr double firstTurn =
            0.5; // makes the program, and few need all the pairs they may have
        double done = 0.0;
        for (const Ranked& each : ranked_) {
            const double share = double(each.pairs.runs()) / double(options_.pairs.max);
            done += isDone(each)      ? 1.0
                    : each.turns == 0 ? 0.0
                                      : firstTurn + (1.0 - firstTurn) * share;
        }
        return finished() ? 1.0 : done / double(models_.size());
    }

    Turn turn() const { return {models_[model_]->label, model_ + 1, models_.size()}; }

    std::vector<ModelCost> costs() const {
        std::vector<ModelCost> costs;
        const double milliseconds = medianInterval(firstTimes_).median;
        for (std::size_t i = 0; i < ranked_.size(); ++i) {
            if (ranked_[i].turns == 0 || ranked_[i].isRefused) {
                continue;
            }
            costs.push_back({models_[i]->id, models_[i]->label,
                             withTimes(ranked_[i].pairs.cost(), {milliseconds, empty_, pixels_}),
                             ranked_[i].instructions, ranked_[i].albedoLoss});
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
    /// Holds what has been measured of a model.
    struct Ranked {
        CostPairs pairs;
        int turns = 0;          ///< counts those that are done
        bool isRefused = false; ///< its program is not drawn
        std::optional<InstructionCount> instructions{};
        std::optional<double> albedoLoss{};
    };

    /// Measures model after model, round after round. A step is a pair of frames.
    Steps run() {
        measureFrame();
        for (; !isOver(); model_ = (model_ + 1) % models_.size()) {
            if (!isDone(ranked_[model_])) {
                co_yield Steps::Pause();
                co_await takeTurn();
            }
        }
    }

    bool isOver() const {
        return std::ranges::all_of(ranked_, [this](const Ranked& each) { return isDone(each); });
    }

    /// Times a few pairs of the model.
    Steps takeTurn() {
        Ranked& model = ranked_[model_];
        const Scene scene = sceneOf(materials_[model_]);
        drawn_->timeOf(first_, view_); // these only warm up
        drawn_->timeOf(scene, view_);
        refuseWhatFailed(model);
        for (int i = 0; i < pairsPerTurn && !(i > 0 && isDone(model)); ++i) {
            co_yield Steps::Pause();
            timePair(model, scene);
        }
        ++model.turns;
    }

    /// Leaves a model out whose frames have mistakes, such as one of the user's that does not
    /// compile.
    void refuseWhatFailed(Ranked& model) {
        const Errors failed = drawn_->takeProblems();
        model.isRefused = model.isRefused || !failed.empty();
        problems_.insert(problems_.end(), failed.begin(), failed.end());
    }

    Scene sceneOf(const Material& material) const {
        Scene scene = subject_.scene;
        scene.objects[subject_.object].material = material;
        return scene;
    }

    /// Measures what is the same for all models: how many pixels are shaded, and the frame without
    /// them.
    void measureFrame() {
        const auto drawable = std::ranges::find_if(materials_, [this](const Material& material) {
            drawn_->timeOf(sceneOf(material), view_);
            return drawn_->takeProblems().empty();
        });
        first_ = sceneOf(drawable == materials_.end() ? materials_.front() : *drawable);
        const auto buffer = drawn_->renderer().surfaces().capture(first_, view_, drawn_->meshes());
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
        ranked_.assign(models_.size(), Ranked{CostPairs(options_.pairs, empty_)});
        began_ = Clock::now();
    }

    /// Tells whether the time is spent and the model has as many pairs as an interval needs.
    bool isLate(const Ranked& model) const {
        const std::chrono::duration<double> spent = Clock::now() - began_;
        return spent.count() > options_.seconds && model.pairs.runs() >= options_.pairs.min;
    }

    bool isDone(const Ranked& model) const {
        if (model.isRefused) {
            return true;
        }
        const bool isMeasured = model.turns >= minTurns && model.pairs.finished();
        return isMeasured || model.pairs.runs() >= options_.pairs.max || isLate(model);
    }

    void timePair(Ranked& model, const Scene& scene) {
        const double first = drawn_->timeOf(first_, view_);
        model.pairs.add(first, drawn_->timeOf(scene, view_));
        firstTimes_.push_back(first);
        refuseWhatFailed(model);
        if (model.pairs.runs() == 1 && !model.isRefused) {
            model.instructions = surfaceInstructions(scene, subject_.object, view_.camera,
                                                     {subject_.catalog, subject_.meshes});
            model.albedoLoss = lossOf(*subject_.catalog, *models_[model_]);
        }
    }

    CostSweep::Subject subject_;
    CostSweep::Options options_;
    std::unique_ptr<TimedFrames> drawn_;
    std::vector<Material> materials_;
    std::vector<const Block*> models_; ///< are those of materials_
    View view_;
    Scene first_;
    MedianInterval empty_;
    std::size_t pixels_ = 0;
    std::vector<Ranked> ranked_; ///< are in the order of models_
    std::size_t model_ = 0;      ///< is the index of the model whose turn it is
    Clock::time_point began_;
    std::vector<double> firstTimes_;
    Errors problems_;
    Steps run_;
};

ModelRanking::ModelRanking(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}

ModelRanking::~ModelRanking() = default;

Result<std::unique_ptr<ModelRanking>> ModelRanking::create(CostSweep::Subject subject,
                                                           const CostSweep::Options& options,
                                                           std::vector<Material> materials) {
    if (subject.object >= subject.scene.objects.size()) {
        return failure("there is no object to measure", "a scene with one");
    }
    materials = rankedMaterials(std::move(materials), *subject.catalog);
    if (materials.empty()) {
        return failure("there is no model to measure", "a material whose model is known");
    }
    auto drawn = TimedFrames::create({subject.catalog, subject.meshes, subject.textures},
                                     chosenSize(options.size), options.programCache);
    if (!drawn) {
        return tl::unexpected(drawn.error());
    }
    return std::unique_ptr<ModelRanking>(new ModelRanking(std::make_unique<Implementation>(
        std::move(subject), options, std::move(*drawn), std::move(materials))));
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
