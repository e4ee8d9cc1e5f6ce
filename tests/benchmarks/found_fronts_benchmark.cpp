// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a search finds what the authors of the models declared: the front of found ways beside
// that of the declared levels, which the search does not see.
#include <algorithm>
#include <array>
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

/// Is a way of a front: at most so far off, at this cost.
struct FrontWay {
    double error = 0.0;
    double cost = 0.0;
};

nlohmann::json searched(const std::string& model) {
    const tests::Outcome outcome =
        tests::run(PATINA_BINARY_DIR "/bin/patina",
                   {.arguments = {"approximate", model, "--gpu", "gcn", "--seconds", "60",
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
        if (way.at("finite").get<bool>()) {
            ways.push_back({way.at("error").get<double>(), way.at("cost").get<double>()});
        }
    }
    return ways;
}

} // namespace

bool foundFronts() {
    std::size_t pairs = 0;
    std::size_t reached = 0;
    for (const char* model : models) {
        const nlohmann::json json = searched(model);
        const double exact = json.at("exact").at("cost").get<double>();
        const auto found = foundIn(json);
        const auto declared = declaredIn(json);
        for (const double budget : budgets) {
            ++pairs;
            reached += costWithin(budget, found, exact) <= costWithin(budget, declared, exact);
        }
    }
    const double share = double(reached) / double(pairs);
    report(fmt::format("found ways beside declared levels of {} models", models.size()),
           fmt::format("no dearer for {} of {} pairs of a model and a budget", reached, pairs),
           share >= wantedShare, fmt::format("{:.0f} %", 100.0 * wantedShare));
    return share >= wantedShare;
}

} // namespace patina::benchmarks
