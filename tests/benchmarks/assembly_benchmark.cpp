// SPDX-License-Identifier: GPL-3.0-or-later
// What putting a program together from blocks costs beside one that is written by hand for the same
// job.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "assembled_program.h"
#include "assembly_scenes.h"
#include "benchmarks.h"
#include "minimal_program.h"
#include "statistics.h"

namespace patina::benchmarks {
namespace {

constexpr int rounds = 21;
constexpr double maxDifference = 1.0 / 255.0;

double largestDifference(const Image& a, const Image& b) {
    double largest = 0.0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const double off = std::abs(std::min(a.pixels[i], 1.0f) - std::min(b.pixels[i], 1.0f));
        largest = std::isnan(off) ? std::numeric_limits<double>::infinity()
                                  : std::max(largest, off);
    }
    return largest;
}

struct Outcome {
    Spread ratio;
    double difference = 0.0;

    bool kept() const { return difference <= maxDifference && ratio.median <= maxAssembled; }
};

/// Both in turn, each first as often as the other.
Outcome compare(BallStage& stage, AssembledProgram& assembled, MinimalProgram& minimal) {
    const auto useAssembled = [&assembled] { assembled.use(); };
    const auto useMinimal = [&minimal] { minimal.use(); };
    Outcome outcome;
    outcome.difference =
        largestDifference(stage.picture(useAssembled), stage.picture(useMinimal));
    std::vector<double> ratios;
    for (int round = 0; round < rounds; ++round) {
        const double first = stage.secondsPerFrame(useAssembled);
        const double byHand =
            stage.secondsPerFrame(useMinimal) + stage.secondsPerFrame(useMinimal);
        ratios.push_back((first + stage.secondsPerFrame(useAssembled)) / byHand);
    }
    outcome.ratio = spreadOf(ratios);
    return outcome;
}

void print(const std::string& name, const Outcome& outcome) {
    report("Assembled / by hand: " + name,
           fmt::format("{}; pictures differ by {:.1e}", text(outcome.ratio, 1.0, ""),
                       outcome.difference),
           outcome.kept(), "<= 1.05, pictures <= 1/255");
    std::fflush(stdout); // there are many, and each takes seconds
}

} // namespace

bool assembly() {
    BallStage stage;
    const auto catalog = std::make_shared<const Catalog>(loadCatalog(standardBlockRoots()));
    bool kept = true;
    std::vector<double> medians;
    for (const std::string model : minimalModels) {
        for (const std::string& surrounding : surroundingsOf(*catalog, model)) {
            const Scene scene = sceneOf(*catalog, model, surrounding);
            AssembledProgram assembled(catalog, scene, stage);
            MinimalProgram minimal(*catalog, model, surrounding, scene, stage);
            const Outcome outcome = compare(stage, assembled, minimal);
            print(model + ", " + surrounding, outcome);
            medians.push_back(outcome.ratio.median);
            kept = kept && outcome.kept();
        }
    }
    const double middle = spreadOf(medians).median;
    report(fmt::format("{} combinations: median of the medians", medians.size()),
           fmt::format("{:.3f}", middle), middle <= maxAssembledMedian, "<= 1.02");
    return kept && middle <= maxAssembledMedian;
}

} // namespace patina::benchmarks
