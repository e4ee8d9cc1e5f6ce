// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a search finds what the authors of the models declared: the front of found ways beside
// that of the declared levels, which the search does not see, for models and for their presets.
#include <algorithm>
#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "benchmarks.h"
#include "statistics.h"
#include "support/program.h"

namespace patina::benchmarks {
namespace {

constexpr double wantedShare = 0.8;
constexpr std::array models{
    "phong",   "gaussian",  "blinn-phong", "cook-torrance",     "oren-nayar",
    "strauss", "lafortune", "he-torrance", "ashikhmin-shirley", "heidrich-seidel"};

/// Are shares of white.
constexpr std::array budgets{1e-4, 1e-3, 1.0 / 255.0, 0.02, 0.05, 0.1, 0.2, 0.5};

/// Is the level by which shipped models have taken over what a search found: no one declared it by
/// hand, so it is not what searches are compared with.
constexpr const char* takenOver = "rounded";

/// Is a way of a front: at most so far off, at this cost.
struct FrontWay {
    double error = 0.0;
    double cost = 0.0;
};

/// Searches for ways of a model, or of a preset with its values.
nlohmann::json searched(const std::string& subject, const char* seconds) {
    const tests::Outcome outcome =
        tests::run(PATINA_BINARY_DIR "/bin/patina",
                   {.arguments = {"approximate", subject, "--gpu", "gcn", "--seconds", seconds,
                                  "--levels", "12", "--budget-error", "1", "--declared", "--json"},
                    .environment = {},
                    .input = {},
                    .timeLimitSeconds = 600.0});
    return nlohmann::json::parse(outcome.out, nullptr, false);
}

/// Returns what the cheapest way costs that is no farther off, the exact one included.
double costWithin(double error, const std::vector<FrontWay>& ways, double exact) {
    double cost = exact;
    for (const FrontWay& way : ways) {
        cost = way.error <= error ? std::min(cost, way.cost) : cost;
    }
    return cost;
}

std::vector<FrontWay> foundIn(const nlohmann::json& json) {
    std::vector<FrontWay> ways;
    for (const auto& way : json.at("ways")) {
        ways.push_back({way.at("atMost").get<double>(), way.at("cost").get<double>()});
    }
    return ways;
}

std::vector<FrontWay> declaredIn(const nlohmann::json& json) {
    std::vector<FrontWay> ways;
    for (const auto& way : json.at("declared")) {
        const auto& levels = way.at("levels");
        const bool isTakenOver = std::any_of(levels.begin(), levels.end(),
                                             [](const auto& level) { return level == takenOver; });
        if (way.at("finite").get<bool>() && !isTakenOver) {
            ways.push_back({way.at("error").get<double>(), way.at("cost").get<double>()});
        }
    }
    return ways;
}

/// Counts pairs of a subject and a budget, and those for which what was found is no dearer.
struct Reached {
    std::size_t pairs = 0;
    std::size_t reached = 0;

    void add(const nlohmann::json& json) {
        const double exact = json.at("exact").at("cost").get<double>();
        const auto found = foundIn(json);
        const auto declared = declaredIn(json);
        for (const double budget : budgets) {
            ++pairs;
            reached += costWithin(budget, found, exact) <= costWithin(budget, declared, exact);
        }
    }

    bool report(const std::string& subjects) const {
        const double share = double(reached) / double(pairs);
        benchmarks::report(
            fmt::format("found ways beside declared levels of {}", subjects),
            fmt::format("no dearer for {} of {} pairs of a subject and a budget", reached, pairs),
            share >= wantedShare, fmt::format("{:.0f} %", 100.0 * wantedShare));
        return share >= wantedShare;
    }
};

/// Returns two of a model's presets.
std::vector<std::string> presetsOf(const std::string& model) {
    std::vector<std::string> files;
    for (const auto& file :
         std::filesystem::directory_iterator(PATINA_SOURCE_DIR "/presets/" + model)) {
        files.push_back(file.path().string());
    }
    std::ranges::sort(files);
    const std::size_t third = files.size() / 3;
    return {files[third], files[std::min(files.size() - 1, 2 * third + 1)]};
}

} // namespace

bool foundFronts() {
    Reached ofModels;
    Reached ofPresets;
    for (const char* model : models) {
        ofModels.add(searched(model, "60"));
        for (const std::string& preset : presetsOf(model)) {
            ofPresets.add(searched(preset, "40"));
        }
    }
    const bool isReached = ofModels.report(fmt::format("{} models", models.size()));
    return ofPresets.report("two presets of each") && isReached;
}

} // namespace patina::benchmarks
