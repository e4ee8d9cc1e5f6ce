// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/effect_table.h"

#include <algorithm>

#include <fmt/format.h>

#include "cli/prediction_table.h"
#include "measure/cost/cost_table.h"

namespace patina {
namespace {

constexpr std::size_t passColumns = 30;

double percentOf(double milliseconds, const EffectCosts& costs) {
    return costs.frame.median > 0.0 ? 100.0 * milliseconds / costs.frame.median : 0.0;
}

/// Holds a row and how many rows enclose it.
struct PlacedRow {
    const EffectRow* row;
    std::size_t depth = 0;
};

/// Adds a row, unless it is there, and then the rows within it.
void place(const EffectRow& row, std::size_t depth, const std::vector<EffectRow>& rows,
           std::vector<PlacedRow>& placed) {
    if (std::ranges::find(placed, &row, &PlacedRow::row) != placed.end()) {
        return;
    }
    placed.push_back({&row, depth});
    for (const EffectRow& other : rows) {
        if (other.within == row.line.effect) {
            place(other, depth + 1, rows, placed);
        }
    }
}

/// Returns each row after the row that it lies within; rows whose enclosing row is not in the list
/// come last.
std::vector<PlacedRow> placedRows(const std::vector<EffectRow>& rows) {
    std::vector<PlacedRow> placed;
    for (const EffectRow& row : rows) {
        if (row.within.empty()) {
            place(row, 0, rows, placed);
        }
    }
    for (const EffectRow& row : rows) {
        place(row, 0, rows, placed);
    }
    return placed;
}

std::string nameOf(const PlacedRow& placed) {
    return (placed.row->in ? "" : "not in: ") + std::string(2 * placed.depth, ' ') +
           placed.row->line.effect;
}

std::string whyText(const EffectLine& line) {
    return line.detail.empty() ? line.reason : fmt::format("{} ({})", line.reason, line.detail);
}

std::string timeText(double milliseconds, const EffectCosts& costs) {
    return fmt::format("{:8.3f} ms {:5.1f} %", milliseconds, percentOf(milliseconds, costs));
}

/// Returns a row's cost, as in "   1.234 ms   9.8 % (1.200 .. 1.300)", with a "!" after the share
/// where too few pairs were timed.
std::string costText(const EffectRow& row, const EffectCosts& costs) {
    const EffectCost* cost = costs.of(row.line.effect);
    if (cost == nullptr) {
        return !row.in ? "" : row.removable ? "       no time for it" : "cannot be left out";
    }
    const std::string interval = fmt::format("{} ({:.3f} .. {:.3f})", cost->isSure() ? "" : " !",
                                             cost->milliseconds.lower, cost->milliseconds.upper);
    return cost->belowNoise() ? "       below noise" + interval
                              : timeText(cost->milliseconds.median, costs) + interval;
}

/// Returns the number of characters of a UTF-8 text.
std::size_t width(const std::string& text) {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
        return (static_cast<unsigned char>(c) & 0xc0u) != 0x80u;
    }));
}

std::string padded(std::string text, std::size_t columns) {
    text.append(columns - std::min(columns, width(text)), ' ');
    return text;
}

std::size_t widest(const std::vector<std::string>& cells) {
    std::size_t columns = 0;
    for (const std::string& cell : cells) {
        columns = std::max(columns, width(cell));
    }
    return columns;
}

bool hasNoTime(const EffectRow& row, const EffectCosts& costs) {
    return row.in && row.removable && costs.of(row.line.effect) == nullptr;
}

std::string totalText(const EffectTable& table) {
    const EffectCosts& costs = *table.costs;
    const double sum = sumOf(costs, table.rows);
    const bool isPart = std::ranges::any_of(
        table.rows, [&costs](const EffectRow& row) { return hasNoTime(row, costs); });
    return fmt::format(
        "\neffects that are within none  {}\n"
        "{}  {}\n"
        "the whole frame               {} ({:.3f} .. {:.3f})\n"
        "{} x {} pixels, {} pairs of frames for each effect, {}; {}\n",
        timeText(sum, costs),
        isPart ? "the rest, some effects too  " : "the rest, which is no effect",
        timeText(costs.rest, costs), timeText(costs.frame.median, costs), costs.frame.lower,
        costs.frame.upper, costs.size.x, costs.size.y, costs.pairs, costs.method,
        costs.secondsNeeded > 0.0 ? "medians; ! too few pairs for an interval of 95 %"
                                  : "medians with intervals of 95 %");
}

/// Lists the passes that take a time that can be seen, and their sum.
std::string passesText(const EffectCosts& costs) {
    if (costs.passes.empty()) {
        return {};
    }
    const double all = costs.ofAllPasses();
    std::string text = "\npass of a frame in which something has moved, each waited for\n";
    for (const PassCost& cost : costs.visiblePasses()) {
        const double milliseconds = cost.milliseconds.median;
        text += fmt::format("{}  {:8.3f} ms {:5.1f} % ({:.3f} .. {:.3f})\n",
                            padded(cost.pass, passColumns), milliseconds,
                            100.0 * milliseconds / all, cost.milliseconds.lower,
                            cost.milliseconds.upper);
    }
    return text;
}

double cyclesOf(const EffectTable& table, const GpuFamily& family) {
    return table.predicted->whole->at(family.id).fragment.cycles;
}

/// Is the card of a family whose milliseconds stand in the table; JSON has those of all.
const GraphicsCard& shownCard(const GpuFamily& family) {
    return family.cards.front();
}

constexpr std::size_t predictedColumns = 50;

/// Returns why nothing is predicted for a row.
std::string unpredictedText(const EffectRow& row, const PredictedEffects& predicted) {
    const Error* problem = predicted.problemOf(row.line.effect);
    return !row.in              ? ""
           : !row.removable     ? "cannot be left out"
           : problem != nullptr ? "not compiled without it"
                                : "";
}

/// Returns what an effect is predicted to take of the shader on a family, as
/// "123 instr.   456 cycles   0.123 ms   7.8 %".
std::string predictedText(const EffectRow& row, const EffectTable& table, const GpuFamily& family) {
    const auto cycles = table.predicted->cyclesOf(row.line.effect, family.id);
    const auto instructions = table.predicted->instructionsOf(row.line.effect, family.id);
    if (!cycles) {
        return unpredictedText(row, *table.predicted);
    }
    if (*cycles == 0.0 && *instructions == 0) {
        return "not in this shader";
    }
    return fmt::format("{:>13} {:>6.0f} cycles {:>8.3f} ms {:>5.1f} %",
                       family.isMali ? std::string() : fmt::format("{} instr.", *instructions),
                       *cycles,
                       predictedMilliseconds(*cycles, fullHdPixels, family, shownCard(family)),
                       100.0 * *cycles / cyclesOf(table, family));
}

std::string predictedText(const EffectRow& row, const EffectTable& table) {
    std::string text;
    for (const GpuFamily* family : table.families) {
        text += fmt::format("{:>{}}  ", predictedText(row, table, *family), predictedColumns - 4) +
                "  ";
    }
    return text;
}

/// Returns the line above the predictions' columns.
std::string familiesText(const EffectTable& table) {
    std::string text;
    for (const GpuFamily* family : table.families) {
        text += fmt::format(
            "{:<{}}", fmt::format("predicted for {}, {}", family->label, shownCard(*family).name),
            predictedColumns);
    }
    text.erase(text.find_last_not_of(' ') + 1);
    return text;
}

std::string predictedTotal(const EffectTable& table) {
    std::string text = "\n";
    for (const GpuFamily* family : table.families) {
        const StageStatistics& stage = table.predicted->whole->at(family->id).fragment;
        text += fmt::format(
            "the object's shader on {}: {}{:.0f} cycles; at 1080p {}\n", family->label,
            family->isMali ? std::string() : fmt::format("{} instructions, ", stage.instructions),
            stage.cycles, cardsText(stage, *family));
    }
    return text + "an effect takes what the shader has more with it than without it\n" +
           predictionLegend(table.predicted->driver, table.families);
}

/// Returns what an effect is predicted to take of the shader on each family.
nlohmann::json predictedJson(const std::string& effect, const EffectTable& table) {
    nlohmann::json json = nlohmann::json::object();
    for (const GpuFamily* family : table.families) {
        if (const auto cycles = table.predicted->cyclesOf(effect, family->id)) {
            json[family->id] = {{"cycles", *cycles},
                                {"percent", 100.0 * *cycles / cyclesOf(table, *family)}};
            for (const GraphicsCard& card : family->cards) {
                json[family->id]["milliseconds"][card.name] =
                    predictedMilliseconds(*cycles, fullHdPixels, *family, card);
            }
            if (!family->isMali) {
                json[family->id]["instructions"] =
                    *table.predicted->instructionsOf(effect, family->id);
            }
        }
    }
    return json;
}

nlohmann::json predictedJson(const EffectTable& table) {
    nlohmann::json json = predictionNotes(table.predicted->driver, table.families);
    for (const GpuFamily* family : table.families) {
        json["families"][family->id] =
            stageJson(table.predicted->whole->at(family->id).fragment, *family);
    }
    return json;
}

nlohmann::json rowJson(const EffectRow& row, const std::optional<EffectCosts>& costs) {
    nlohmann::json json{{"effect", row.line.effect},
                        {"detail", row.line.detail},
                        {"reason", row.line.reason},
                        {"removable", row.removable},
                        {"within", row.within}};
    const EffectCost* cost = costs ? costs->of(row.line.effect) : nullptr;
    if (cost != nullptr) {
        json["milliseconds"] = intervalJson(cost->milliseconds, std::max(cost->pairs, 1));
        json["percent"] = percentOf(cost->milliseconds.median, *costs);
        json["belowNoise"] = cost->belowNoise();
        json["pairs"] = cost->pairs;
        json["sure"] = cost->isSure();
    }
    return json;
}

nlohmann::json costsJson(const EffectTable& table) {
    const EffectCosts& costs = *table.costs;
    nlohmann::json json{{"frame", intervalJson(costs.frame, std::max(costs.pairs, 1))},
                        {"effects", sumOf(costs, table.rows)},
                        {"rest", costs.rest},
                        {"size", {costs.size.x, costs.size.y}},
                        {"pairs", costs.pairs},
                        {"method", costs.method}};
    for (const PassCost& cost : costs.passes) {
        json["passes"].push_back(
            {{"pass", cost.pass}, {"milliseconds", intervalJson(cost.milliseconds, cost.frames)}});
    }
    if (costs.secondsNeeded > 0.0) {
        json["secondsNeeded"] = costs.secondsNeeded;
    }
    return json;
}

} // namespace

std::string objectText(const ShownObject& object) {
    const std::string place = fmt::format("object {} of {}", object.number, object.count);
    return object.name.empty() ? place : fmt::format("{}, {}", object.name, place);
}

std::string tableText(const EffectTable& table) {
    std::vector<std::string> names;
    std::vector<std::string> times;
    const std::vector<PlacedRow> rows = placedRows(table.rows);
    for (const PlacedRow& placed : rows) {
        names.push_back(nameOf(placed));
        times.push_back(table.costs ? costText(*placed.row, *table.costs) : std::string());
    }
    const std::size_t nameColumns = widest(names);
    const std::size_t timeColumns = table.costs ? widest(times) + 2 : 0;
    std::string out = objectText(table.object) + '\n';
    if (table.predicted) {
        out += std::string(nameColumns + 2 + timeColumns, ' ') + familiesText(table) + '\n';
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
        out += padded(names[i], nameColumns) + "  " + padded(times[i], timeColumns) +
               (table.predicted ? predictedText(*rows[i].row, table) : std::string()) +
               whyText(rows[i].row->line) + '\n';
    }
    return out + (table.costs ? totalText(table) + passesText(*table.costs) : std::string()) +
           (table.predicted ? predictedTotal(table) : std::string());
}

nlohmann::json tableJson(const EffectTable& table) {
    nlohmann::json json{{"object",
                         {{"name", table.object.name},
                          {"number", table.object.number},
                          {"count", table.object.count}}},
                        {"effects", nlohmann::json::array()},
                        {"leftOut", nlohmann::json::array()}};
    for (const EffectRow& row : table.rows) {
        if (row.in) {
            json["effects"].push_back(rowJson(row, table.costs));
            if (table.predicted) {
                json["effects"].back()["predicted"] = predictedJson(row.line.effect, table);
            }
        } else {
            json["leftOut"].push_back({{"what", row.line.effect}, {"reason", row.line.reason}});
        }
    }
    if (table.costs) {
        json["costs"] = costsJson(table);
    }
    if (table.predicted) {
        json["predicted"] = predictedJson(table);
    }
    return json;
}

} // namespace patina
