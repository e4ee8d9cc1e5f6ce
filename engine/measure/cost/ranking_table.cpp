// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/cost/ranking_table.h"

#include <cmath>

#include <fmt/format.h>

#include "measure/cost/cost_table.h"

namespace patina {
namespace {

constexpr int rankedDigits = 2;

/// Returns a share in percent, without a sign where it rounds to 0; "-" where there is none.
std::string shareText(const std::optional<double>& share) {
    return share ? fmt::format("{:.1f} %", std::round(1000.0 * *share) / 10.0 + 0.0) : "-";
}

nlohmann::json numberJson(const std::optional<double>& number) {
    return number ? nlohmann::json(*number) : nlohmann::json();
}

std::string rowText(const ModelCost& each) {
    const InstructionCount count = each.instructions.value_or(InstructionCount());
    return fmt::format("{:<28} {:<22}{:>10} {:>7} {:7} {:7} {:7} {:7} {:7} {:>8}\n", each.label,
                       ratioText(each.cost, each.bound, rankedDigits), nanosecondsText(each.cost),
                       instructionsText(each.instructions), count.arithmetic, count.transcendental,
                       count.texture, count.branch, count.memory, shareText(each.albedoLoss));
}

} // namespace

std::string rankingText(const std::vector<ModelCost>& costs) {
    std::string text =
        fmt::format("{:<28} {:>6} {:<15} {:>9} {:>7} {:>7} {:>7} {:>7} {:>7} {:>7} {:>8}\n",
                    "model", "time", "(in this run)", "ns/pixel", "instr.", "sums", "roots",
                    "images", "branch", "memory", "loss");
    for (const ModelCost& each : costs) {
        text += rowText(each);
    }
    return text + fmt::format("time: beside the quickest model, and where it lies with a "
                              "probability of 95 % in this run: what else a machine does may give "
                              "another run other times; {}\n"
                              "loss: of an even white sky's light, with the model's own colours; "
                              "below 0: it sends out more than arrives\n",
                              signsText("the quickest model"));
}

std::string rankingCsv(const std::vector<ModelCost>& costs) {
    std::string text = "model,label,ratio,ratio_lower,ratio_upper,ns_per_pixel,runs,settled,"
                       "below_noise,instructions,arithmetic,transcendental,texture,branch,memory,"
                       "albedo_loss\n";
    for (const ModelCost& each : costs) {
        const ChoiceCost& cost = each.cost;
        const InstructionCount count = each.instructions.value_or(InstructionCount());
        text +=
            fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", each.model,
                        csvText(each.label), cost.ratio.median, boundsCsv(cost.ratio, cost.runs),
                        cost.nanosecondsPerPixel, cost.runs, cost.settled ? 1 : 0,
                        cost.belowNoise ? 1 : 0, instructionsText(each.instructions),
                        count.arithmetic, count.transcendental, count.texture, count.branch,
                        count.memory, each.albedoLoss ? fmt::format("{}", *each.albedoLoss) : "-");
    }
    return text;
}

nlohmann::json rankingJson(const std::vector<ModelCost>& costs) {
    nlohmann::json json = nlohmann::json::array();
    for (const ModelCost& each : costs) {
        json.push_back({{"model", each.model},
                        {"label", each.label},
                        {"ratio", intervalJson(each.cost.ratio, each.cost.runs)},
                        {"nanosecondsPerPixel", each.cost.nanosecondsPerPixel},
                        {"runs", each.cost.runs},
                        {"settled", each.cost.settled},
                        {"belowNoise", each.cost.belowNoise},
                        {"instructions", countJson(each.instructions)},
                        {"albedoLoss", numberJson(each.albedoLoss)}});
    }
    return json;
}

} // namespace patina
