// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/prediction_table.h"

#include <algorithm>

#include <fmt/format.h>

#include "catalog/json_text.h"
#include "measure/cost/cost_table.h"

namespace patina {
namespace {

using Families = std::span<const GpuFamily* const>;

/// Is a row of a table: something that was compiled.
struct PredictedRow {
    std::string name;
    const Result<FamilyStatistics>& statistics;
};

std::vector<PredictedRow> rowsOf(std::span<const PredictedWay> ways) {
    std::vector<PredictedRow> rows;
    for (const PredictedWay& way : ways) {
        rows.push_back({levelsText(way.levels), way.statistics});
    }
    return rows;
}

std::vector<PredictedRow> rowsOf(std::span<const PredictedModel> models) {
    std::vector<PredictedRow> rows;
    for (const PredictedModel& model : models) {
        rows.push_back({model.label, model.statistics});
    }
    return rows;
}

std::size_t widestName(std::span<const PredictedRow> rows) {
    std::size_t columns = 0;
    for (const PredictedRow& row : rows) {
        columns = std::max(columns, row.name.size());
    }
    return columns;
}

/// Returns a number that malioc does not tell, and "-" for Mali.
std::string toldText(double number, const GpuFamily& family) {
    return family.isMali ? "-" : fmt::format("{:.0f}", number);
}

/// Returns the number of loops that are guessed, and behind it the rounds that were counted.
std::string loopsText(const StageStatistics& stage) {
    return stage.countedRounds > 0.0 ? fmt::format("{}+{:.0f}r", stage.loops, stage.countedRounds)
                                     : fmt::format("{}", stage.loops);
}

std::string lineText(const StageStatistics& stage, const GpuFamily& family) {
    return fmt::format("{:<9} {:>6} {:>5} {:>5} {:>6} {:>5} {:>6} {:>7.0f} {:>7}  {}\n",
                       family.label, toldText(stage.instructions, family), stage.vectorRegisters,
                       stage.scalarRegisters, stage.spilledRegisters, toldText(stage.waves, family),
                       loopsText(stage), stage.cycles, toldText(stage.latency, family),
                       cardsText(stage, family));
}

bool hasMali(Families families) {
    return std::ranges::any_of(families, [](const GpuFamily* family) { return family->isMali; });
}

std::string rowsText(std::span<const PredictedRow> rows, Families families) {
    const std::size_t columns = widestName(rows);
    std::string text =
        fmt::format("{:<{}}  {:<9} {:>6} {:>5} {:>5} {:>6} {:>5} {:>6} {:>7} {:>7}  {}\n", "",
                    columns, "", "instr.", "VGPRs", "SGPRs", "spills", "waves", "loops", "cycles",
                    "latency", "predicted at 1080p");
    for (const PredictedRow& row : rows) {
        std::string name = row.name;
        if (!row.statistics) {
            text += fmt::format("{:<{}}  {}\n", name, columns, row.statistics.error().problem);
            continue;
        }
        for (const GpuFamily* family : families) {
            text += fmt::format("{:<{}}  {}", name, columns,
                                lineText(row.statistics->at(family->id).fragment, *family));
            name.clear();
        }
    }
    return text;
}

/// Adds what was compiled to an object of JSON, or why it was not.
nlohmann::json withStatistics(nlohmann::json json, const Result<FamilyStatistics>& statistics,
                              Families families) {
    if (!statistics) {
        json["problem"] = statistics.error().problem;
        return json;
    }
    for (const GpuFamily* family : families) {
        json["families"][family->id] = stageJson(statistics->at(family->id).fragment, *family);
    }
    return json;
}

/// Returns a number that malioc does not tell, and nothing for Mali.
std::string toldCsv(double number, const GpuFamily& family) {
    return family.isMali ? std::string() : fmt::format("{}", number);
}

/// Returns a line for each card of a family, which begins with `name`.
std::string stageCsv(const std::string& name, const StageStatistics& stage,
                     const GpuFamily& family) {
    std::string text;
    for (const GraphicsCard& card : family.cards) {
        text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},\n", name, family.id,
                            csvText(card.name), toldCsv(stage.instructions, family),
                            stage.vectorRegisters, stage.scalarRegisters, stage.spilledRegisters,
                            toldCsv(stage.waves, family), stage.loops, stage.countedRounds,
                            stage.cycles, toldCsv(stage.latency, family),
                            predictedMilliseconds(stage.cycles, fullHdPixels, family, card));
    }
    return text;
}

constexpr const char* csvColumns =
    "family,card,instructions,vgprs,sgprs,spills,waves,loops,counted_rounds,"
    "cycles,latency,milliseconds,problem\n";

/// Returns the lines of a row; the row that was not compiled has one, with the reason.
std::string rowCsv(const std::string& name, const Result<FamilyStatistics>& statistics,
                   Families families) {
    if (!statistics) {
        return name + std::string(13, ',') + csvText(statistics.error().problem) + '\n';
    }
    std::string text;
    for (const GpuFamily* family : families) {
        text += stageCsv(name, statistics->at(family->id).fragment, *family);
    }
    return text;
}

} // namespace

std::string cardsText(const StageStatistics& stage, const GpuFamily& family) {
    std::string text;
    for (const GraphicsCard& card : family.cards) {
        text += fmt::format("{}{} {:.2f} ms", text.empty() ? "" : ", ", card.name,
                            predictedMilliseconds(stage.cycles, fullHdPixels, family, card));
    }
    return text;
}

std::string predictionCsv(std::span<const NamedWays> presets, Families families) {
    std::string text = std::string("preset,levels,") + csvColumns;
    for (const auto& [preset, ways] : presets) {
        for (const PredictedWay& way : ways) {
            text += rowCsv(csvText(preset) + ',' + csvText(levelsText(way.levels)), way.statistics,
                           families);
        }
    }
    return text;
}

std::string predictionCsv(std::span<const PredictedModel> models, Families families) {
    std::string text = std::string("model,label,") + csvColumns;
    for (const PredictedModel& model : models) {
        text +=
            rowCsv(csvText(model.model) + ',' + csvText(model.label), model.statistics, families);
    }
    return text;
}

std::string predictionText(std::span<const PredictedWay> ways, Families families) {
    return rowsText(rowsOf(ways), families);
}

std::string predictionText(std::span<const PredictedModel> models, Families families) {
    return rowsText(rowsOf(models), families);
}

nlohmann::json stageJson(const StageStatistics& stage, const GpuFamily& family) {
    nlohmann::json json = toJson(stage);
    json["countedRounds"] = stage.countedRounds;
    if (family.isMali) {
        for (const char* untold : {"instructions", "waves", "lanes", "latency"}) {
            json.erase(untold);
        }
    }
    for (const GraphicsCard& card : family.cards) {
        json["milliseconds"][card.name] =
            predictedMilliseconds(stage.cycles, fullHdPixels, family, card);
    }
    return json;
}

nlohmann::json predictionJson(std::span<const PredictedWay> ways, Families families) {
    nlohmann::json json = nlohmann::json::array();
    for (const PredictedWay& way : ways) {
        json.push_back(withStatistics({{"levels", way.levels}}, way.statistics, families));
    }
    return json;
}

nlohmann::json predictionJson(std::span<const PredictedModel> models, Families families) {
    nlohmann::json json = nlohmann::json::array();
    for (const PredictedModel& model : models) {
        json.push_back(withStatistics({{"model", model.model}, {"label", model.label}},
                                      model.statistics, families));
    }
    return json;
}

std::string predictionLegend(const std::string& driver, Families families) {
    std::string text = fmt::format(
        "predicted by the compiler of {} for cards that are not here: the fragment stage of the "
        "object's shader, on each pixel of 1920 x 1080\n"
        "cycles: of a SIMD unit for 64 pixels, when it holds as many waves as it can, with what "
        "its look-ups of texels take in texture units, as if nothing were computed meanwhile; "
        "latency: of one wave alone\n"
        "loops: those of which the compiler does not know how often they run; it takes 8 times, "
        "and one within another 4 times for each of these; 0+12r: 12 rounds of loops that run as "
        "often as directions and values call for, on the mean of 256 pairs of directions\n"
        "left out: {}\n",
        driver, leftOutOfPrediction);
    if (hasMali(families)) {
        text += "Mali: cycles of a core in the pipeline that takes longest; VGPRs are its work "
                "registers, SGPRs its uniform registers; where it has a loop, each of its "
                "instructions counts once\n";
    }
    for (const GpuFamily* family : families) {
        for (const GraphicsCard& card : family->cards) {
            text += fmt::format("{}: {} compute units at {:.0f} MHz ({})\n", card.name,
                                card.computeUnits, card.megahertz, card.source);
        }
    }
    return text;
}

nlohmann::json predictionNotes(const std::string& driver, Families families) {
    nlohmann::json cards = nlohmann::json::object();
    for (const GpuFamily* family : families) {
        for (const GraphicsCard& card : family->cards) {
            cards[card.name] = {{"family", family->id},
                                {"computeUnits", card.computeUnits},
                                {"megahertz", card.megahertz},
                                {"source", card.source}};
        }
    }
    return {{"driver", driver},
            {"predicted", true},
            {"leftOut", leftOutOfPrediction},
            {"cards", cards}};
}

} // namespace patina
