// SPDX-License-Identifier: GPL-3.0-or-later
// Whether models that are predicted to be dear on a graphics card are dear where they are measured.
#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "benchmarks.h"
#include "statistics.h"
#include "support/program.h"

namespace patina::benchmarks {
namespace {

constexpr double wantedCorrelation = 0.9;

nlohmann::json allModels(std::vector<std::string> more) {
    const std::string scene = PATINA_SOURCE_DIR "/presets/three-lights.patina-scene.json";
    std::vector<std::string> command{"cost", "--all-models", "--scene", scene, "--json"};
    command.insert(command.end(), more.begin(), more.end());
    const tests::Outcome outcome =
        tests::run(PATINA_BINARY_DIR "/bin/patina", {.arguments = std::move(command),
                                                     .environment = {},
                                                     .input = {},
                                                     .timeLimitSeconds = 600.0});
    return nlohmann::json::parse(outcome.out, nullptr, false);
}

/// Maps each model to its cycles on a family, those with loops left out: how often these run is the
/// compiler's guess.
std::map<std::string, double> predictedCycles(const std::string& family) {
    std::map<std::string, double> cycles;
    for (const auto& model : allModels({"--gpu", family}).at("models")) {
        const auto& stage = model.at("families").at(family);
        if (stage.at("loops").get<int>() == 0) {
            cycles[model.at("model")] = stage.at("cycles").get<double>();
        }
    }
    return cycles;
}

/// Returns the place of each number in the order of all; equal ones share the mean of theirs.
std::vector<double> ranks(const std::vector<double>& numbers) {
    std::vector<double> ranks;
    for (const double number : numbers) {
        const auto below = std::ranges::count_if(numbers, [=](double x) { return x < number; });
        const auto equal = std::ranges::count(numbers, number);
        ranks.push_back(double(below) + 0.5 * double(equal - 1));
    }
    return ranks;
}

/// Returns Spearman's rank correlation, -1 .. 1.
double rankCorrelation(const std::vector<double>& x, const std::vector<double>& y) {
    const std::vector<double> ranksOfX = ranks(x);
    const std::vector<double> ranksOfY = ranks(y);
    const double middle = 0.5 * double(x.size() - 1);
    double xy = 0.0;
    double xx = 0.0;
    double yy = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        xy += (ranksOfX[i] - middle) * (ranksOfY[i] - middle);
        xx += (ranksOfX[i] - middle) * (ranksOfX[i] - middle);
        yy += (ranksOfY[i] - middle) * (ranksOfY[i] - middle);
    }
    return xy / std::sqrt(xx * yy);
}

} // namespace

bool predictedCost() {
    const nlohmann::json measured = allModels({"--size", "256x256"});
    bool kept = true;
    for (const char* family : {"gcn", "rdna2", "rdna3"}) {
        const std::map<std::string, double> cycles = predictedCycles(family);
        std::vector<double> predictions;
        std::vector<double> times;
        for (const auto& model : measured) {
            const auto found = cycles.find(model.at("model").get<std::string>());
            if (found != cycles.end()) {
                predictions.push_back(found->second);
                times.push_back(model.at("nanosecondsPerPixel").get<double>());
            }
        }
        const double correlation = rankCorrelation(predictions, times);
        const bool isKept = correlation >= wantedCorrelation;
        report(fmt::format("predicted cost of {} models on {}", times.size(), family),
               fmt::format("{:.3f} rank correlation with measured times", correlation), isKept,
               fmt::format("at least {}", wantedCorrelation));
        kept = kept && isKept;
    }
    return kept;
}

} // namespace patina::benchmarks
