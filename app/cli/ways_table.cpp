// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/ways_table.h"

#include <fmt/format.h>

#include "measure/approximation/approximated_block.h"

namespace patina {
namespace {

nlohmann::json sizeJson(glm::ivec2 size) {
    return {size.x, size.y};
}

nlohmann::json frameJson(const WayInFrame& way) {
    const ChoiceCost& cost = way.cost;
    return {{"error",
             {{"max", way.error.max},
              {"mean", way.error.mean},
              {"p99", way.error.p99},
              {"flip", way.error.flip}}},
            {"time",
             {{"ratio", cost.ratio.median},
              {"lower", cost.ratio.lower},
              {"upper", cost.ratio.upper},
              {"pairs", cost.runs},
              {"belowNoise", cost.belowNoise}}}};
}

std::string ratioText(const ChoiceCost& cost) {
    return cost.belowNoise ? std::string("below noise")
                           : fmt::format("{:.2f} ({:.2f} .. {:.2f})", cost.ratio.median,
                                         cost.ratio.lower, cost.ratio.upper);
}

/// Returns the two columns of a way in the frame, or their heads for none; empty where nothing was
/// drawn.
std::string frameColumns(const WaysTable& table, const WayInFrame* way) {
    if (!table.inFrame) {
        return {};
    }
    return way == nullptr
               ? fmt::format("{:<9}  {:<18}  ", "in frame", "time here, of exact")
               : fmt::format("{:>8.2g}   {:<19}  ", way->error.p99, ratioText(way->cost));
}

std::string frameText(const WaysInFrame& frame) {
    return fmt::format("in frame: the error that 99 of 100 pixels of {} x {} keep, over the light "
                       "there, against {}; time here: of {} x {} pixels, {:.1f} ms as it is, {}\n",
                       frame.errorSize.x, frame.errorSize.y, frame.groundTruth, frame.timedSize.x,
                       frame.timedSize.y, frame.milliseconds, frame.timer);
}

} // namespace

nlohmann::json waysJson(const WaysTable& table) {
    const CheaperWays& ways = table.ways;
    nlohmann::json json{{"block", table.block.id},
                        {"kind", table.block.kind},
                        {"unit", ways.unit},
                        {"exact", {{"cost", ways.exact.cost}, {"error", ways.exact.error}}},
                        {"ways", nlohmann::json::array()},
                        {"changes", ways.moves},
                        {"tried", ways.tried},
                        {"unseenCases", ways.heldOut},
                        {"statedFor", ways.places + valuesInWords(ways)},
                        {"checkedOnDevice", table.isChecked},
                        {"finished", !ways.isStopped},
                        {"seconds", table.seconds}};
    for (std::size_t i = 0; i < ways.ways.size(); ++i) {
        const CheaperWay& way = ways.ways[i];
        json["ways"].push_back({{"level", foundLevelId(i)},
                                {"cost", way.cost},
                                {"error", way.error},
                                {"atMost", statedError(way)},
                                {"meanError", way.meanError},
                                {"forValues", way.isForValues},
                                {"does", way.words}});
        if (table.inFrame) {
            json["ways"].back()["frame"] = frameJson(table.inFrame->ways[i]);
        }
    }
    if (table.inFrame) {
        json["frame"] = {{"against", table.inFrame->groundTruth},
                         {"comparedSize", sizeJson(table.inFrame->errorSize)},
                         {"timedSize", sizeJson(table.inFrame->timedSize)},
                         {"milliseconds", table.inFrame->milliseconds},
                         {"timer", table.inFrame->timer}};
    }
    for (const Error& note : ways.notes) {
        json["notes"].push_back(note.text());
    }
    return json;
}

std::string waysText(const WaysTable& table) {
    const CheaperWays& ways = table.ways;
    std::string text = fmt::format(
        "{}: {:.0f} {} (predicted); floats alone are up to {:.2g} off in the exact way\n",
        table.block.id, ways.exact.cost, ways.unit, ways.exact.error);
    if (ways.ways.empty()) {
        return text + "nothing cheaper was found\n";
    }
    const std::string heads = frameColumns(table, nullptr);
    text += "   cost  of exact  at most off  on the mean  " + heads + "what is done\n";
    for (std::size_t i = 0; i < ways.ways.size(); ++i) {
        const CheaperWay& way = ways.ways[i];
        text += fmt::format("{:7.0f}  {:6.0f} %  {:11.2g}  {:11.2g}  {}", way.cost,
                            100.0 * way.cost / ways.exact.cost, statedError(way), way.meanError,
                            table.inFrame ? frameColumns(table, &table.inFrame->ways[i]) : "");
        for (std::size_t word = 0; word < way.words.size(); ++word) {
            text += (word == 0 ? "" : "\n" + std::string(46 + heads.size(), ' ')) + way.words[word];
        }
        text += '\n';
    }
    return text +
           fmt::format("errors are for {}{}\n"
                       "{} changes, {} texts compiled; errors where white is 1, on {} cases that "
                       "the search did not see{}; {:.0f} s\n",
                       ways.places, valuesInWords(ways), ways.moves, ways.tried, ways.heldOut,
                       table.isChecked ? " and on the graphics device"
                                       : ", not checked on the graphics device",
                       table.seconds) +
           (table.inFrame ? frameText(*table.inFrame) : "");
}

nlohmann::json declaredJson(std::span<const DeclaredWay> ways) {
    nlohmann::json json = nlohmann::json::array();
    for (const DeclaredWay& way : ways) {
        json.push_back({{"levels", way.levels},
                        {"cost", way.cost},
                        {"error", way.error.worst},
                        {"meanError", way.error.mean},
                        {"finite", way.error.isSafe}});
    }
    return json;
}

std::string declaredText(std::span<const DeclaredWay> ways) {
    std::string text = ways.empty() ? "it has no levels of its own\n" : "its own levels:\n";
    for (const DeclaredWay& way : ways) {
        text += fmt::format("{:7.0f}  {:8}  {:11.2g}  {:11.2g}  {}\n", way.cost, "",
                            way.error.worst, way.error.mean, levelsText(way.levels));
    }
    return text;
}

} // namespace patina
