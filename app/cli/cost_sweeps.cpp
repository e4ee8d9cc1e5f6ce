// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/cost_sweeps.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <iostream>
#include <utility>

#include <fmt/format.h>

#include "cli/command.h"
#include "cli/mapped_point.h"
#include "cli/picture.h"
#include "measure/cost/predicted_chart.h"
#include "measure/cost/scaling_sweep.h"

namespace patina {
namespace {

/// Lists the edges of a scaling's pictures, in 24ths of the largest one's.
constexpr std::array partsOfEdge{3, 4, 6, 8, 12, 16, 24};
constexpr int wholeEdge = 24;
constexpr glm::ivec2 fullHd{1920, 1080};

CostSweep::Options sweepOptions(const CostRequest& options) {
    CostSweep::Options wanted;
    wanted.size = options.picture.size;
    wanted.scope = options.ofPicture ? Choice::Scope::Picture : Choice::Scope::Material;
    wanted.programCache = programCacheFolder();
    wanted.seconds = options.seconds;
    wanted.pairs = options.pairs;
    wanted.combinations = !options.singles;
    return wanted;
}

/// Returns the edges, in pixels, of a scaling whose largest picture has this edge.
std::vector<int> edgesUpTo(int edge) {
    std::vector<int> edges;
    for (const int part : partsOfEdge) {
        const int each = std::max(1, edge * part / wholeEdge);
        if (edges.empty() || edges.back() < each) {
            edges.push_back(each);
        }
    }
    return edges;
}

std::string workText(const SweepStep& step) {
    switch (step.work) {
    case SweepStep::Work::GroundTruthFrame:
        return "the ground truth";
    case SweepStep::Work::ConvergedFrame:
        return "a converged picture";
    case SweepStep::Work::EmptyFrame:
        return "an empty picture";
    default:
        return levelsText(step.levels);
    }
}

std::string stepText(const SweepStep& step) {
    return fmt::format("step {} of {}: {}, {:.0f} %", step.number, step.of, workText(step),
                       100.0 * step.share);
}

/// Returns the message for work that takes longer than --seconds.
std::string durationText(double seconds) {
    return fmt::format("about {:.0f} minutes: each frame of so many directions takes seconds here; "
                       "Ctrl-C ends with what is measured by then\n",
                       std::max(seconds / 60.0, 1.0));
}

tl::unexpected<Errors> nothingYet() {
    return tl::unexpected(
        oneError(failure("stopped before anything was measured", "some patience").value()));
}

} // namespace

namespace {

/// Compiles the ways of a sweep for the family of a graphics card, each when it is asked for.
class WayCompiler {
  public:
    WayCompiler(const CostSweep::Subject& subject, const CardOfFamily& card, const LongWork& work)
        : subject_{subject.scene, subject.object, subject.meshes, subject.catalog},
          families_{card.family} {
        subject_.scene.camera = subject.camera;
        options_.isStopped = [&work] { return work.isStopped(); };
        options_.before = &before_;
    }

    /// Returns the cycles for 64 pixels; nothing where the way does not compile.
    std::optional<double> cyclesOf(const ChosenLevels& levels) {
        auto made = predictedPoints(subject_, std::span(&levels, 1), families_, options_);
        if (!made) {
            problems_ = made.error();
            return std::nullopt;
        }
        points_.driver = std::move(made->driver);
        points_.ways.push_back(std::move(made->ways.front()));
        const Result<FamilyStatistics>& statistics = points_.ways.back().statistics;
        const bool isThere = statistics && statistics->contains(families_.front()->id);
        return isThere ? std::optional(statistics->at(families_.front()->id).fragment.cycles)
                       : std::nullopt;
    }

    const PredictedPoints& points() const { return points_; }
    const Errors& problems() const { return problems_; }

  private:
    PredictedSubject subject_;
    std::array<const GpuFamily*, 1> families_;
    FamilyCompilerOptions options_;
    CompiledBefore before_;
    PredictedPoints points_;
    Errors problems_;
};

} // namespace

Checked<Sweep> swept(CostSweep::Subject subject, const CostRequest& options, LongWork& work) {
    const auto named = namedLevels(
        options.ofPicture ? choicesOfPicture(subject.scene, *subject.catalog)
                          : materialChoices(subject.scene, subject.object, *subject.catalog),
        options);
    if (!named) {
        return tl::unexpected(oneError(named.error()));
    }
    CostSweep::Options wanted = sweepOptions(options);
    wanted.present = *named;
    std::optional<WayCompiler> compiler;
    if (options.card) {
        compiler.emplace(subject, *options.card, work);
        wanted.given = [&compiler](const ChosenLevels& levels) {
            return compiler->cyclesOf(levels);
        };
    }
    auto sweep = CostSweep::create(std::move(subject), wanted);
    if (!sweep) {
        return tl::unexpected(oneError(sweep.error()));
    }
    bool isWarned = false;
    while (!(*sweep)->finished() && !work.isStopped()) {
        (*sweep)->step(std::chrono::milliseconds(200));
        const SweepStep step = (*sweep)->doing();
        if (step.secondsInAll > wanted.seconds && !std::exchange(isWarned, true)) {
            work.report({});
            std::cerr << durationText(step.secondsInAll);
        }
        work.report(stepText(step));
    }
    if (compiler && !compiler->problems().empty() && !work.isStopped()) {
        return tl::unexpected(compiler->problems());
    }
    if (!(*sweep)->problems().empty()) {
        return tl::unexpected((*sweep)->problems());
    }
    Sweep made{(*sweep)->chart(), {}, {}};
    if (made.chart.points.empty()) {
        return nothingYet();
    }
    if (compiler) {
        auto predicted = predictedChart(made.chart, compiler->points(), *options.card,
                                        options.shown.value_or(fullHd));
        if (!predicted) {
            return tl::unexpected(oneError(predicted.error()));
        }
        made.chart = std::move(*predicted);
    }
    if (!options.errorMap.empty() && !work.isStopped()) {
        made.mapped = mappedPoint(made.chart, *named, options).levels;
        made.errors = (*sweep)->errorMap(made.mapped);
    }
    return made;
}

Checked<std::vector<ScalingCurve>> scaled(CostSweep::Subject subject, const CostRequest& options,
                                          LongWork& work) {
    ScalingSweep::Options wanted;
    if (const int edge = options.picture.size.x; edge > 0) {
        wanted.edge = edge;
        wanted.edges = edgesUpTo(edge);
    }
    wanted.programCache = programCacheFolder();
    wanted.seconds = options.seconds;
    auto sweep = ScalingSweep::create(std::move(subject), wanted);
    if (!sweep) {
        return tl::unexpected(oneError(sweep.error()));
    }
    while (!(*sweep)->finished() && !work.isStopped()) {
        (*sweep)->step();
        const ScalingSweep::Turn turn = (*sweep)->turn();
        work.report(fmt::format("{} of {}: {}, round {} of {}", turn.number, turn.of,
                                axisText(turn.axis), turn.round, turn.rounds));
    }
    if (!(*sweep)->problems().empty()) {
        return tl::unexpected((*sweep)->problems());
    }
    if ((*sweep)->curves().empty()) {
        return nothingYet();
    }
    return (*sweep)->curves();
}

Checked<std::vector<ModelCost>> ranked(CostSweep::Subject subject, const CostRequest& options,
                                       LongWork& work, std::vector<Material> materials) {
    auto ranking =
        ModelRanking::create(std::move(subject), sweepOptions(options), std::move(materials));
    if (!ranking) {
        return tl::unexpected(oneError(ranking.error()));
    }
    while (!(*ranking)->finished() && !work.isStopped()) {
        (*ranking)->step();
        const ModelRanking::Turn turn = (*ranking)->turn();
        work.report(fmt::format("{:3.0f} %  model {} of {}: {}", 100.0 * (*ranking)->progress(),
                                turn.number, turn.of, turn.label));
    }
    std::vector<ModelCost> costs = (*ranking)->costs();
    if (costs.empty()) {
        return (*ranking)->problems().empty() ? nothingYet()
                                              : tl::unexpected((*ranking)->problems());
    }
    report((*ranking)->problems()); // of models that are left out
    return costs;
}

Checked<std::vector<ModelCost>> rankedModels(CostSweep::Subject subject, const CostRequest& options,
                                             LongWork& work) {
    return ranked(std::move(subject), options, work, {});
}

} // namespace patina
