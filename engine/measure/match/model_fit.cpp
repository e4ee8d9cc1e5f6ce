// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/match/model_fit.h"

#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <utility>

#include <ceres/cost_function.h>
#include <ceres/problem.h>
#include <ceres/solver.h>
#include <glm/geometric.hpp>

#include "measure/eval/model_values.h"
#include "measure/match/free_numbers.h"

namespace patina {
namespace {

constexpr std::size_t triedSets = 512;
constexpr std::size_t triedDirections = 96;
constexpr std::size_t roughDirections = 256;
constexpr std::size_t fineDirections = 512;
constexpr std::size_t lastDirections = 1024;
constexpr int roughSteps = 16;
constexpr int fineSteps = 50;
constexpr int lastSteps = 80;
constexpr int lastRounds = 4;
/// Counts fits that are improved as far as they go: the best, and others with at most so many times
/// its error.
constexpr std::size_t finished = 2;
constexpr double isNear = 1.5;

/// Is the step by which derivatives are found, in lengths of a slider.
constexpr double derivativeStep = 1e-6;

constexpr std::size_t channels = 3;

/// Is an error that no eye sees.
constexpr double isTheSame = 1e-5;
/// Is an error that only rounding leaves.
constexpr double isExact = 1e-9;
/// Is how near to an end of its range a number counts as at it, and how far it is moved from there,
/// in lengths of its slider.
constexpr double atEnd = 1e-3;
constexpr double fromEnd = 0.3;
/// Is how much less error other choices must have to be taken.
constexpr double isBetter = 0.95;
/// Bounds how many choices are changed, one after the other.
constexpr int maxChoices = 3;

/// Keeps a relative error finite where the target is black.
constexpr double relativeFloor = 0.01;

/// Returns CIE's lightness (CIE 15:2004, equation 8.1), as a share of that of a white surface. What
/// is brighter than that counts by its logarithm, since no screen shows it so.
double lightness(double value) {
    constexpr double dark = 216.0 / 24389.0;
    const double shown = value > 1.0 ? 1.0 + std::log(value) : value;
    return shown > dark ? 1.16 * std::cbrt(shown) - 0.16 : 243.89 / 27.0 * shown;
}

/// Returns the target's values as the measure of a fit compares them.
std::vector<double> wantedOf(const MatchTarget& target, MatchError error) {
    std::vector<double> wanted;
    wanted.reserve(3 * target.values.size());
    for (const glm::dvec3& value : target.values) {
        for (int c = 0; c < 3; ++c) {
            wanted.push_back(error == MatchError::Log         ? std::log1p(value[c])
                             : error == MatchError::Lightness ? lightness(value[c])
                                                              : value[c]);
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
    case MatchError::Lightness:
        return lightness(model) - wanted;
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
    Fit(EvalCase model, const MatchTarget& target, const FitOptions& options,
        const Catalog& catalog)
        : model_(std::move(model)), values_(ModelValues::of(model_, catalog)),
          free_(model_, options.only), numbers_(free_.of(model_)), target_(target),
          wanted_(wantedOf(target, options.error)), error_(options.error) {}

    /// Writes the differences of all directions and channels; they are those of these numbers.
    bool differences(const double* numbers, double* out) const {
        if (!values_) {
            return false;
        }
        const ModelValues values = values_->with(modelWith(numbers));
        const double* wanted = wanted_.data();
        for (std::size_t i = 0; i < target_.pairs.size(); ++i) {
            const glm::dvec3 value = values.at(target_.pairs[i]);
            const double share = target_.weights.empty() ? 1.0 : std::sqrt(target_.weights[i]);
            for (int c = 0; c < 3; ++c) {
                *out++ = share * difference(error_, value[c], *wanted++);
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

    /// Moves numbers that lie at an end of their range inwards; returns whether there are any.
    /// Where several do the same together, one at its end may hold the others back.
    bool leaveEnds() {
        bool hasLeft = false;
        for (std::size_t k = 0; k < numbers_.size(); ++k) {
            for (const auto& [end, inwards] :
                 {std::pair(free_.min(k), fromEnd), std::pair(free_.max(k), -fromEnd)}) {
                if (std::abs(numbers_[k] - end) < atEnd) {
                    numbers_[k] = end + inwards;
                    hasLeft = true;
                }
            }
        }
        return hasLeft;
    }

    /// Improves the numbers.
    void improve(int steps, const Progress& progress);

    EvalCase model() const { return modelWith(numbers_.data()); }

    std::size_t size() const { return numbers_.size(); }
    std::size_t differenceCount() const { return channels * target_.pairs.size(); }
    const FreeNumbers& free() const { return free_; }

  private:
    EvalCase modelWith(const double* numbers) const {
        EvalCase model = model_;
        free_.set(model, numbers);
        return model;
    }

    EvalCase model_;
    Result<ModelValues> values_;
    FreeNumbers free_;
    std::vector<double> numbers_;
    const MatchTarget& target_;
    std::vector<double> wanted_;
    MatchError error_;
};

/// Gives Ceres the differences of a fit and their derivatives, which are found by a step in each
/// number. The numbers of one colour take their steps together where each was seen to change other
/// channels, and so do all numbers that changed nothing.
class Differences : public ceres::CostFunction {
  public:
    explicit Differences(const Fit& fit) : fit_(fit) {
        mutable_parameter_block_sizes()->push_back(static_cast<int>(fit.size()));
        set_num_residuals(static_cast<int>(fit.differenceCount()));
    }

    bool Evaluate(const double* const* numbers, double* out, double** jacobians) const override {
        if (!fit_.differences(numbers[0], out)) {
            return false;
        }
        return jacobians == nullptr || jacobians[0] == nullptr ||
               findDerivatives(numbers[0], out, jacobians[0]);
    }

  private:
    using Channels = std::bitset<channels>;

    /// Are numbers that take their steps together, and what each of them changes.
    struct Group {
        std::vector<std::size_t> numbers;
        std::vector<Channels> changed;

        Channels all() const {
            Channels sum;
            for (const Channels each : changed) {
                sum |= each;
            }
            return sum;
        }
    };

    /// Writes a row for each difference and a column for each number.
    bool findDerivatives(const double* numbers, const double* here, double* jacobian) const {
        std::fill_n(jacobian, fit_.size() * fit_.differenceCount(), 0.0);
        std::vector<Channels> changed(fit_.size());
        for (const Group& group : groups_.empty() ? eachAlone(fit_.size()) : groups_) {
            if (!stepped(numbers, here, group, jacobian, changed)) {
                return false;
            }
        }
        if (groups_.empty()) {
            groups_ = grouped(changed);
        }
        return true;
    }

    /// Takes the steps of a group; returns false where the model cannot be evaluated.
    bool stepped(const double* numbers, const double* here, const Group& group, double* jacobian,
                 std::vector<Channels>& changed) const {
        std::vector<double> beside(numbers, numbers + fit_.size());
        std::vector<double> steps;
        for (const std::size_t k : group.numbers) {
            const double step =
                numbers[k] + derivativeStep > fit_.free().max(k) ? -derivativeStep : derivativeStep;
            beside[k] += step;
            steps.push_back(beside[k] - numbers[k]);
        }
        std::vector<double> there(fit_.differenceCount());
        if (!fit_.differences(beside.data(), there.data())) {
            return false;
        }
        for (std::size_t row = 0; row < there.size(); ++row) {
            const double change = there[row] - here[row];
            for (std::size_t i = 0; i < group.numbers.size() && change != 0.0; ++i) {
                const std::size_t k = group.numbers[i];
                if (group.changed[i].none()) { // it changed nothing so far
                    return eachStepped(numbers, here, group, jacobian, changed);
                }
                if (group.changed[i][row % channels]) {
                    jacobian[row * fit_.size() + k] = change / steps[i];
                    changed[k].set(row % channels);
                }
            }
        }
        return true;
    }

    bool eachStepped(const double* numbers, const double* here, const Group& group,
                     double* jacobian, std::vector<Channels>& changed) const {
        return std::ranges::all_of(group.numbers, [&](std::size_t k) {
            return stepped(numbers, here, {{k}, {Channels().set()}}, jacobian, changed);
        });
    }

    static std::vector<Group> eachAlone(std::size_t count) {
        std::vector<Group> groups;
        for (std::size_t k = 0; k < count; ++k) {
            groups.push_back({{k}, {Channels().set()}});
        }
        return groups;
    }

    std::vector<Group> grouped(const std::vector<Channels>& changed) const {
        std::vector<Group> groups;
        for (std::size_t k = 0; k < changed.size(); ++k) {
            const auto joins = [&](const Group& group) {
                return group.all().none() ? changed[k].none()
                                          : changed[k].any() && (group.all() & changed[k]).none() &&
                                                fit_.free().areOfOne(group.numbers.front(), k);
            };
            auto group = std::ranges::find_if(groups, joins);
            if (group == groups.end()) {
                group = groups.insert(groups.end(), Group());
            }
            group->numbers.push_back(k);
            group->changed.push_back(changed[k]);
        }
        return groups;
    }

    const Fit& fit_;
    mutable std::vector<Group> groups_; ///< is empty before the first derivatives
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
    ceres::Problem problem;
    problem.AddResidualBlock(new Differences(*this), nullptr, numbers_.data());
    for (std::size_t i = 0; i < numbers_.size(); ++i) {
        numbers_[i] = std::clamp(numbers_[i], free_.min(i), free_.max(i));
        problem.SetParameterLowerBound(numbers_.data(), int(i), free_.min(i));
        problem.SetParameterUpperBound(numbers_.data(), int(i), free_.max(i));
    }
    Canceller canceller(progress);
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::DENSE_QR;
    options.max_num_iterations = steps;
    options.function_tolerance = 1e-9;
    options.parameter_tolerance = 1e-9;
    options.logging_type = ceres::SILENT;
    options.num_threads = 1;
    // The cubic one of Ceres asks for derivatives at each place that is tried between the bounds.
    options.line_search_interpolation_type = ceres::BISECTION;
    options.callbacks.push_back(&canceller);
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);
}

/// Adds the model with each other state of each choice that a block's descriptor offers.
void addChoices(std::vector<EvalCase>& others, const EvalCase& model, EvalBlock EvalCase::*of) {
    const EvalBlock& block = model.*of;
    for (const Parameter& parameter : block.block->parameters) {
        const ParameterTypeInfo& type = infoOf(parameter.type);
        if (parameter.compiled != Compiled::Yes || type.states == nullptr ||
            type.function != nullptr || !counts(parameter, block)) {
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
        : few(all.first(triedDirections)), some(all.first(roughDirections)),
          many(all.first(fineDirections)) {}
};

/// Returns the best of random sets of values.
std::vector<EvalCase> scattered(const EvalCase& model, const Targets& targets,
                                const FitOptions& options, const Catalog& catalog) {
    std::minstd_rand random(1);
    std::vector<std::pair<double, EvalCase>> tried;
    for (std::size_t i = 0; i < triedSets; ++i) {
        Fit fit(model, targets.few, options, catalog);
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
             const FitOptions& options, const Catalog& catalog, const Progress& progress) {
    std::vector<std::pair<double, EvalCase>> rough;
    for (EvalCase& start : starts) {
        Fit fit(std::move(start), roughly, options, catalog);
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
        Fit fine(std::move(rough[i].second), targets.many, options, catalog);
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

double relativeError(const EvalCase& model, const MatchTarget& target, const Catalog& catalog) {
    const Result<ModelValues> values = ModelValues::of(model, catalog);
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

std::span<const std::string_view> matchErrorWords() {
    static constexpr std::array<std::string_view, 4> words{"log", "relative", "linear",
                                                           "lightness"};
    return words;
}

std::optional<MatchError> matchErrorOf(std::string_view word) {
    const std::span<const std::string_view> words = matchErrorWords();
    const auto found = std::ranges::find(words, word);
    return found == words.end() ? std::nullopt
                                : std::optional(static_cast<MatchError>(found - words.begin()));
}

Result<ModelFit> fittedModel(const EvalCase& model, const MatchTarget& target,
                             const FitOptions& options, const Catalog& catalog,
                             const Progress& progress) {
    const auto values = ModelValues::of(model, catalog);
    if (!values) {
        return tl::unexpected(values.error());
    }
    for (const DirectionPair& pair : target.pairs) {
        values->at(pair);
    }
    if (values->isEndless()) {
        return tl::unexpected(endlessError(*model.block.block));
    }
    // A narrow highlight may pass between the directions of a fit: all of them decide.
    const auto errorOf = [&](const EvalCase& found) {
        return Fit(found, target, options, catalog).error();
    };
    const Targets targets(target);
    std::vector<EvalCase> starts = scattered(model, targets, options, catalog);
    starts.insert(starts.begin(), model);
    EvalCase found =
        improved(std::move(starts), targets.some, targets, options, catalog, progress).model();
    double smallest = errorOf(found);
    // Other choices may look the same with other numbers: they have to be better.
    for (int round = 0; round < maxChoices && smallest > isTheSame; ++round) {
        std::vector<EvalCase> others =
            options.only.empty() ? withOtherChoices(found, catalog) : std::vector<EvalCase>();
        if (others.empty() || progress.cancelled) {
            break;
        }
        EvalCase other =
            improved(std::move(others), targets.few, targets, options, catalog, progress).model();
        const double error = errorOf(other);
        if (error > isBetter * smallest) {
            break;
        }
        found = std::move(other);
        smallest = error;
    }
    const MatchTarget nearlyAll = target.first(lastDirections);
    for (int round = 0; round < lastRounds && smallest > isExact; ++round) {
        Fit last(found, nearlyAll, options, catalog);
        if (round > 0 && !last.leaveEnds()) {
            break;
        }
        last.improve(lastSteps, progress);
        const double error = errorOf(last.model());
        const bool isWorth = error < isBetter * smallest;
        if (error < smallest) {
            found = last.model();
            smallest = error;
        }
        if (round > 0 && !isWorth) {
            break;
        }
    }
    return ModelFit{found, smallest, relativeError(found, target, catalog)};
}

} // namespace patina
