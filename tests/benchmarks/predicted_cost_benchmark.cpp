// SPDX-License-Identifier: GPL-3.0-or-later
// Whether models, and presets with each of their levels, that are predicted to be dear on a
// graphics card are dear where they are measured.
#include <algorithm>
#include <cmath>
#include <filesystem>
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

/// What `patina cost` says as JSON, under three lights.
nlohmann::json costs(std::vector<std::string> more) {
    const std::string scene = PATINA_SOURCE_DIR "/presets/three-lights.patina-scene.json";
    more.insert(more.begin(), {"cost", "--scene", scene, "--json"});
    const tests::Outcome outcome = tests::run(
        PATINA_BINARY_DIR "/bin/patina",
        {.arguments = std::move(more), .environment = {}, .input = {}, .timeLimitSeconds = 3600.0});
    return nlohmann::json::parse(outcome.out, nullptr, false);
}

nlohmann::json allModels(std::vector<std::string> more) {
    more.emplace_back("--all-models");
    return costs(std::move(more));
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

std::vector<std::string> shippedPresets() {
    std::vector<std::string> presets;
    for (const auto& file :
         std::filesystem::recursive_directory_iterator(PATINA_SOURCE_DIR "/presets")) {
        if (file.path().string().ends_with(".patina.json")) {
            presets.push_back(file.path().string());
        }
    }
    std::ranges::sort(presets);
    return presets;
}

/// Is a preset with the levels of its choices that are not exact.
std::string wayOf(const nlohmann::json& preset, const nlohmann::json& way) {
    return preset.get<std::string>() + ' ' + way.at("levels").dump();
}

bool isKept(const std::string& what, const std::vector<double>& predictions,
            const std::vector<double>& times) {
    const double correlation = rankCorrelation(predictions, times);
    const bool isEnough = correlation >= wantedCorrelation;
    report(fmt::format("predicted cost of {}", what),
           fmt::format("{:.3f} rank correlation with measured times", correlation), isEnough,
           fmt::format("at least {}", wantedCorrelation));
    return isEnough;
}

/// Compares all presets, each exact and with each of its levels, whose loops are all counted.
bool presetsAndLevels() {
    const std::vector<std::string> presets = shippedPresets();
    std::vector<std::string> measure{"--size", "128x128", "--seconds", "2", "--singles"};
    measure.insert(measure.end(), presets.begin(), presets.end());
    std::map<std::string, double> times;
    for (const auto& chart : costs(measure)) {
        for (const auto& point : chart.at("points")) {
            times[wayOf(chart.at("preset"), point)] = point.at("nanosecondsPerPixel");
        }
    }
    std::vector<std::string> predict{"--gpu", "gcn,rdna2,rdna3"};
    predict.insert(predict.end(), presets.begin(), presets.end());
    const nlohmann::json predicted = costs(predict);
    bool kept = true;
    for (const char* family : {"gcn", "rdna2", "rdna3"}) {
        std::vector<double> predictions;
        std::vector<double> measured;
        for (const auto& preset : predicted.at("presets")) {
            for (const auto& way : preset.at("ways")) {
                const auto found = times.find(wayOf(preset.at("preset"), way));
                if (found != times.end() && way.contains("families") &&
                    way.at("families").at(family).at("loops") == 0) {
                    predictions.push_back(way.at("families").at(family).at("cycles"));
                    measured.push_back(found->second);
                }
            }
        }
        kept = isKept(fmt::format("{} presets and levels on {}", measured.size(), family),
                      predictions, measured) &&
               kept;
    }
    return kept;
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
        kept = isKept(fmt::format("{} models on {}", times.size(), family), predictions, times) &&
               kept;
    }
    return presetsAndLevels() && kept;
}

} // namespace patina::benchmarks
