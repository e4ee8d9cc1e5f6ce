// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/match/model_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <random>
#include <utility>

#include <ceres/dynamic_numeric_diff_cost_function.h>
#include <ceres/problem.h>
#include <ceres/solver.h>
#include <glm/geometric.hpp>

#include "measure/eval/model_values.h"
#include "measure/match/free_numbers.h"

namespace patina {
namespace {

constexpr std::size_t triedSets = 128;
constexpr std::size_t triedDirections = 96;
constexpr std::size_t roughDirections = 256;
constexpr std::size_t fineDirections = 512;
constexpr std::size_t lastDirections = 1024;
constexpr int roughSteps = 12;
constexpr int fineSteps = 20;
constexpr int lastSteps = 15;
/// Counts fits that are improved as far as they go: the best, and others with at most so many times
/// its error.
constexpr std::size_t finished = 2;
constexpr double isNear = 1.5;

/// Keeps a number away from its upper end while it is fitted: a derivative is found by a step up,
/// which changes nothing beyond the end.
constexpr double derivativeRoom = 1e-5;

/// Is an error that no eye sees.
constexpr double isTheSame = 1e-5;
/// Is how much less error other choices must have to be taken.
constexpr double isBetter = 0.95;
/// Bounds how many choices are changed, one after the other.
constexpr int maxChoices = 3;

/// Keeps a relative error finite where the target is black.
constexpr double relativeFloor = 0.01;

/// Returns the target's values as the measure of a fit compares them.
std::vector<double> wantedOf(const MatchTarget& target, MatchError error) {
    std::vector<double> wanted;
    wanted.reserve(3 * target.values.size());
    for (const glm::dvec3& value : target.values) {
        for (int c = 0; c < 3; ++c) {
            wanted.push_back(error == MatchError::Log ? std::log1p(value[c]) : value[c]);
        }
    }
    return wanted;
}

/// Returns the difference of one channel in the measure of a fit; `wanted` is of wantedOf().
double difference(MatchError error, double model, double wanted) {
    switch (error) {
    case MatchError::Relative:
        return (model - wanted) / (wanted + relativeFloor);
    case MatchError::Linear:
        return model - wanted;
    default:
        return std::log1p(model) - wanted;
    }
}

double rootMeanSquare(const std::vector<double>& numbers) {
    double sum = 0.0;
    for (const double number : numbers) {
        sum += number * number;
    }
    return std::sqrt(sum / double(std::max<std::size_t>(numbers.size(), 1)));
}

/// Holds a fit in work: the free numbers of a model against a target.
class Fit {
  public:
    Fit(EvalCase model, const MatchTarget& target, MatchError error)
        : model_(std::move(model)), free_(model_), numbers_(free_.of(model_)), target_(target),
          wanted_(wantedOf(target, error)), error_(error) {}

    /// Writes the differences of all directions and channels; they are those of these numbers.
    bool differences(const double* numbers, double* out) const {
        const Result<ModelValues> values = ModelValues::of(modelWith(numbers));
        if (!values) {
            return false;
        }
        const double* wanted = wanted_.data();
        for (std::size_t i = 0; i < target_.pairs.size(); ++i) {
            const glm::dvec3 value = values->at(target_.pairs[i]);
            for (int c = 0; c < 3; ++c) {
                *out++ = difference(error_, value[c], *wanted++);
            }
        }
        return true;
    }

    double error() const {
        std::vector<double> all(3 * target_.pairs.size());
        return differences(numbers_.data(), all.data()) ? rootMeanSquare(all)
                                                        : std::numeric_limits<double>::infinity();
    }

    /// Sets all numbers to random places of their sliders.
    void scatter(std::minstd_rand& random) {
        std::uniform_real_distribution<double> uniform(0.0, 1.0);
        for (std::size_t k = 0; k < numbers_.size(); ++k) {
            numbers_[k] = std::clamp(uniform(random), free_.min(k), free_.max(k));
        }
    }

    /// Improves the numbers.
    void improve(int steps, const Progress& progress);

    EvalCase model() const { return modelWith(numbers_.data()); }

  private:
    EvalCase modelWith(const double* numbers) const {
        EvalCase model = model_;
        free_.set(model, numbers);
        return model;
    }

    EvalCase model_;
    FreeNumbers free_;
    std::vector<double> numbers_;
    const MatchTarget& target_;
    std::vector<double> wanted_;
    MatchError error_;
};

/// Is how Ceres asks for the differences.
struct Residuals {
    const Fit* fit;
    bool operator()(const double* const* numbers, double* out) const {
        return fit->differences(numbers[0], out);
    }
};

/// Ends a solver when the work is cancelled.
class Canceller : public ceres::IterationCallback {
  public:
    explicit Canceller(const Progress& progress) : progress_(progress) {}
    ceres::CallbackReturnType operator()(const ceres::IterationSummary& /*summary*/) override {
        return progress_.cancelled ? ceres::SOLVER_TERMINATE_SUCCESSFULLY : ceres::SOLVER_CONTINUE;
    }

  private:
    const Progress& progress_;
};

void Fit::improve(int steps, const Progress& progress) {
    if (numbers_.empty() || progress.cancelled) {
        return;
    }
    using Cost = ceres::DynamicNumericDiffCostFunction<Residuals, ceres::FORWARD>;
    auto cost = std::make_unique<Cost>(new Residuals{this});
    cost->AddParameterBlock(int(numbers_.size()));
    cost->SetNumResiduals(int(3 * target_.pairs.size()));
    ceres::Problem problem;
    problem.AddResidualBlock(cost.release(), nullptr, numbers_.data());
    for (std::size_t i = 0; i < numbers_.size(); ++i) {
        const double upper = free_.max(i) - derivativeRoom;
        numbers_[i] = std::clamp(numbers_[i], free_.min(i), upper);
        problem.SetParameterLowerBound(numbers_.data(), int(i), free_.min(i));
        problem.SetParameterUpperBound(numbers_.data(), int(i), upper);
    }
    Canceller canceller(progress);
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::DENSE_QR;
    options.max_num_iterations = steps;
    options.function_tolerance = 1e-9;
    options.parameter_tolerance = 1e-9;
    options.logging_type = ceres::SILENT;
    options.num_threads = 1;
    options.callbacks.push_back(&canceller);
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);
    for (std::size_t i = 0; i < numbers_.size(); ++i) {
        const bool isAtEnd = numbers_[i] > free_.max(i) - 1.5 * derivativeRoom;
        numbers_[i] = isAtEnd ? free_.max(i) : numbers_[i];
    }
}

/// Adds the model with each other state of each choice that a block's descriptor offers.
void addChoices(std::vector<EvalCase>& others, const EvalCase& model, EvalBlock EvalCase::*of) {
    const EvalBlock& block = model.*of;
    for (const Parameter& parameter : block.block->parameters) {
        const ParameterTypeInfo& type = infoOf(parameter.type);
        if (parameter.compiled != Compiled::Yes || type.states == nullptr ||
            type.function != nullptr) {
            continue;
        }
        const auto held = block.values.find(parameter.id);
        const Value& now = held != block.values.end() ? held->second : parameter.defaultValue;
        for (const Value& state : type.states(parameter)) {
            if (state != now) {
                others.push_back(model);
                (others.back().*of).values[parameter.id] = state;
            }
        }
    }
}

/// Returns the model with each other choice, and with each other block in its slot.
std::vector<EvalCase> withOtherChoices(const EvalCase& model, const Catalog& catalog) {
    std::vector<EvalCase> others;
    addChoices(others, model, &EvalCase::block);
    if (model.slot.block != nullptr) {
        addChoices(others, model, &EvalCase::slot);
        for (const Block* filler : catalog.ofKind(model.slot.block->kind)) {
            if (filler != model.slot.block) {
                others.push_back(model);
                others.back().slot = {filler, defaultValues(*filler), {}};
            }
        }
    }
    return others;
}

/// Holds a target at more and more directions: the fewer, the quicker.
struct Targets {
    MatchTarget few;
    MatchTarget some;
    MatchTarget many;

    explicit Targets(const MatchTarget& all)
        : few(all.thinned(triedDirections)), some(all.thinned(roughDirections)),
          many(all.thinned(fineDirections)) {}
};

/// Returns the best of random sets of values.
std::vector<EvalCase> scattered(const EvalCase& model, const Targets& targets,
                                const FitOptions& options) {
    std::minstd_rand random(1);
    std::vector<std::pair<double, EvalCase>> tried;
    for (std::size_t i = 0; i < triedSets; ++i) {
        Fit fit(model, targets.few, options.error);
        fit.scatter(random);
        tried.emplace_back(fit.error(), fit.model());
    }
    std::ranges::stable_sort(tried, {}, &std::pair<double, EvalCase>::first);
    std::vector<EvalCase> best;
    for (std::size_t i = 0; i < std::min(options.starts, tried.size()); ++i) {
        best.push_back(std::move(tried[i].second));
    }
    return best;
}

/// Improves these a little, and the best of them as far as it goes.
Fit improved(std::vector<EvalCase> starts, const MatchTarget& roughly, const Targets& targets,
             const FitOptions& options, const Progress& progress) {
    std::vector<std::pair<double, EvalCase>> rough;
    for (EvalCase& start : starts) {
        Fit fit(std::move(start), roughly, options.error);
        fit.improve(roughSteps, progress);
        rough.emplace_back(fit.error(), fit.model());
    }
    std::ranges::stable_sort(rough, {}, &std::pair<double, EvalCase>::first);
    std::optional<Fit> best;
    const double nearest = isNear * rough.front().first;
    for (std::size_t i = 0; i < std::min(finished, rough.size()); ++i) {
        if (i > 0 && rough[i].first > nearest) {
            break;
        }
        Fit fine(std::move(rough[i].second), targets.many, options.error);
        fine.improve(fineSteps, progress);
        if (!best || fine.error() < best->error()) {
            best.emplace(std::move(fine));
        }
        if (best->error() < isTheSame) {
            break;
        }
    }
    return std::move(*best);
}

double relativeError(const EvalCase& model, const MatchTarget& target) {
    const Result<ModelValues> values = ModelValues::of(model);
    double missed = 0.0;
    double all = 0.0;
    for (std::size_t i = 0; values && i < target.pairs.size(); ++i) {
        const glm::dvec3 off = values->at(target.pairs[i]) - target.values[i];
        missed += glm::dot(off, off);
        all += glm::dot(target.values[i], target.values[i]);
    }
    return all > 0.0 ? std::sqrt(missed / all) : 0.0;
}

} // namespace

std::optional<MatchError> matchErrorOf(std::string_view word) {
    constexpr std::array<std::string_view, 3> words{"log", "relative", "linear"};
    const auto found = std::ranges::find(words, word);
    return found == words.end() ? std::nullopt
                                : std::optional(static_cast<MatchError>(found - words.begin()));
}

Result<ModelFit> fittedModel(const EvalCase& model, const MatchTarget& target,
                             const FitOptions& options, const Catalog& catalog,
                             const Progress& progress) {
    if (const auto code = ModelValues::of(model); !code) {
        return tl::unexpected(code.error());
    }
    // A narrow highlight may pass between the directions of a fit: all of them decide.
    const auto errorOf = [&](const EvalCase& found) {
        return Fit(found, target, options.error).error();
    };
    const Targets targets(target);
    std::vector<EvalCase> starts = scattered(model, targets, options);
    starts.insert(starts.begin(), model);
    EvalCase found = improved(std::move(starts), targets.some, targets, options, progress).model();
    double smallest = errorOf(found);
    // Other choices may look the same with other numbers: they have to be better.
    for (int round = 0; round < maxChoices && smallest > isTheSame; ++round) {
        std::vector<EvalCase> others = withOtherChoices(found, catalog);
        if (others.empty() || progress.cancelled) {
            break;
        }
        EvalCase other =
            improved(std::move(others), targets.few, targets, options, progress).model();
        const double error = errorOf(other);
        if (error > isBetter * smallest) {
            break;
        }
        found = std::move(other);
        smallest = error;
    }
    if (smallest > isTheSame) {
        const MatchTarget nearlyAll = target.thinned(lastDirections);
        Fit last(found, nearlyAll, options.error);
        last.improve(lastSteps, progress);
        if (const double error = errorOf(last.model()); error < smallest) {
            found = last.model();
            smallest = error;
        }
    }
    return ModelFit{found, smallest, relativeError(found, target)};
}

} // namespace patina
