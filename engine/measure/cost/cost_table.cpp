// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/cost/cost_table.h"

#include <algorithm>

#include <fmt/format.h>

namespace patina {
namespace {

constexpr int ratioDigits = 3;

char signOf(Standing standing) {
    return standing == Standing::OnFront ? '*' : standing == Standing::Tie ? '=' : ' ';
}

std::size_t widest(const CostChart& chart) {
    std::size_t columns = 0;
    for (const CostPoint& point : chart.points) {
        columns = std::max(columns, levelsText(point.levels).size());
    }
    return columns;
}

const char* boundSign(RatioBound bound) {
    return bound == RatioBound::AtMost ? "<" : bound == RatioBound::AtLeast ? ">" : "";
}

std::string pointText(const CostPoint& point, const CostChart& chart) {
    const ChoiceCost& cost = point.cost;
    const FrameError& error = point.error;
    return fmt::format("{:<24}{:>10} {:>7} {} {:7.1e} {:8.1e} {:8.1e} {:8.1e} {:6.2f} % {:8.1e}",
                       ratioText(cost, chart.boundOf(point), ratioDigits), nanosecondsText(cost),
                       instructionsText(point.instructions),
                       chart.isAgainstConverged(point) ? '~' : ' ', error.p99, error.max,
                       error.mean, error.rms, 100.0 * error.stepShare, error.flip);
}

std::string headText(const CostChart& chart, std::size_t columns) {
    return fmt::format("  {:<{}}    {:<22} ns/pixel  instr.   p99 err      max     mean      RMS"
                       "    8-bit     FLIP\n",
                       "", columns,
                       chart.predictedFor.empty() ? "time (of 95 % of runs)" : "predicted time");
}

/// Returns a line for each point on the front that others tie with.
std::string tiesText(const CostChart& chart) {
    std::string text;
    for (const std::size_t i : costFront(chart.points)) {
        std::string names;
        for (const std::size_t other : tiesOf(chart.points, chart.points[i])) {
            names += (names.empty() ? "" : ", ") + levelsText(chart.points[other].levels);
        }
        if (!names.empty()) {
            text += fmt::format("{} cannot be told from {}\n", levelsText(chart.points[i].levels),
                                names);
        }
    }
    return text;
}

/// Returns a text as a line below the table; empty for an empty text.
std::string lineOf(const std::string& text) {
    return text.empty() ? text : text + '\n';
}

std::string convergedLine(const CostChart& chart) {
    const std::string text = convergedText(chart);
    return text.empty() ? "" : "~ " + text + '\n';
}

nlohmann::json errorJson(const FrameError& error) {
    return {{"max", error.max},   {"mean", error.mean},           {"rms", error.rms},
            {"p99", error.p99},   {"stepShare", error.stepShare}, {"shown", error.shown},
            {"flip", error.flip}, {"pixels", error.pixels}};
}

nlohmann::json pointJson(const CostPoint& point, const CostChart& chart, Standing standing) {
    nlohmann::json levels = nlohmann::json::object();
    for (const auto& [choice, level] : point.levels) {
        levels[choice] = level;
    }
    return {{"levels", levels},
            {"error", errorJson(point.error)},
            {"ratio", intervalJson(point.cost.ratio, point.cost.runs)},
            {"milliseconds", intervalJson(point.cost.milliseconds, point.cost.runs)},
            {"nanosecondsPerPixel", point.cost.nanosecondsPerPixel},
            {"instructions", countJson(point.instructions)},
            {"runs", point.cost.runs},
            {"settled", point.cost.settled},
            {"belowNoise", point.cost.belowNoise},
            {"front", standing == Standing::OnFront},
            {"tie", standing == Standing::Tie},
            {"ties", tiesOf(chart.points, point)},
            {"againstConverged", chart.isAgainstConverged(point)}};
}

nlohmann::json convergedJson(const CostChart& chart) {
    if (!chart.converged) {
        return {};
    }
    const ConvergedRender& render = *chart.converged;
    return {{"choice", render.choice},
            {"directions", render.directions},
            {"noise", errorJson(render.noise)},
            {"exact", errorJson(render.finest)}};
}

nlohmann::json choiceJson(const Choice& choice) {
    nlohmann::json levels = nlohmann::json::array();
    for (const ChoiceLevel& level : choice.levels) {
        levels.push_back({{"id", level.id}, {"label", level.label}, {"doc", level.doc}});
    }
    const bool isOfPicture = choice.scope == Choice::Scope::Picture;
    return {{"id", choice.id},
            {"key", choice.key},
            {"label", choice.label},
            {"doc", choice.doc},
            {"block", choice.block},
            {"levels", levels},
            {"scope", isOfPicture ? "picture" : "material"}};
}

nlohmann::json sameJson(const std::vector<SameLevel>& same) {
    nlohmann::json all = nlohmann::json::array();
    for (const SameLevel& each : same) {
        all.push_back({{"choice", each.choice},
                       {"level", each.level},
                       {"as", each.as},
                       {"samples", each.samples}});
    }
    return all;
}

} // namespace

std::string costText(const CostChart& chart) {
    const std::vector<Standing> standing = standings(chart.points);
    const std::size_t columns = widest(chart);
    std::string text = headText(chart, columns);
    for (std::size_t i = 0; i < chart.points.size(); ++i) {
        const CostPoint& point = chart.points[i];
        text += fmt::format("{} {:<{}}  {}\n", signOf(standing[i]), levelsText(point.levels),
                            columns, pointText(point, chart));
    }
    text += tiesText(chart) + lineOf(sameText(chart)) + lineOf(leftOutText(chart));
    const std::string_view meaning =
        chart.predictedFor.empty()
            ? "* worth choosing: nothing measured errs no more and is as fast, as far as can be "
              "told; = may be, too: the difference is within the noise"
            : "* worth choosing: nothing errs no more and is as fast; = is as fast and cannot be "
              "told from it in error";
    return text + fmt::format("{}; {}\n"
                              "{} x {} pixels, {} of them shaded; {}; {:.3f} ms without them\n"
                              "errors against {}\n{}",
                              meaning, signsText("the exact way"), chart.size.x, chart.size.y,
                              chart.pixels, chart.timer, chart.emptyMilliseconds, chart.groundTruth,
                              convergedLine(chart));
}

std::string costCsv(const CostChart& chart, const std::string& name, bool withNames) {
    std::string text =
        withNames ? "preset,levels,ratio,ratio_lower,ratio_upper,milliseconds,ns_per_pixel,"
                    "instructions,runs,p99,max,mean,rms,step_share,shown,flip,front,"
                    "settled,below_noise,tie,predicted_for\n"
                  : "";
    const std::vector<Standing> standing = standings(chart.points);
    for (std::size_t i = 0; i < chart.points.size(); ++i) {
        const CostPoint& point = chart.points[i];
        const ChoiceCost& cost = point.cost;
        const FrameError& error = point.error;
        text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n",
                            csvText(name), csvText(levelsText(point.levels)), cost.ratio.median,
                            boundsCsv(cost.ratio, cost.runs), cost.milliseconds.median,
                            cost.nanosecondsPerPixel, instructionsText(point.instructions),
                            cost.runs, error.p99, error.max, error.mean, error.rms, error.stepShare,
                            error.shown, error.flip, standing[i] == Standing::OnFront ? 1 : 0,
                            cost.settled ? 1 : 0, cost.belowNoise ? 1 : 0,
                            standing[i] == Standing::Tie ? 1 : 0, csvText(chart.predictedFor));
    }
    return text;
}

nlohmann::json costJson(const CostChart& chart) {
    const std::vector<Standing> standing = standings(chart.points);
    nlohmann::json choices = nlohmann::json::array();
    for (const Choice& choice : chart.choices) {
        choices.push_back(choiceJson(choice));
    }
    nlohmann::json points = nlohmann::json::array();
    for (std::size_t i = 0; i < chart.points.size(); ++i) {
        points.push_back(pointJson(chart.points[i], chart, standing[i]));
    }
    return {{"choices", choices},
            {"points", points},
            {"size", {chart.size.x, chart.size.y}},
            {"pixels", chart.pixels},
            {"exactMilliseconds", chart.exactMilliseconds},
            {"emptyMilliseconds", chart.emptyMilliseconds},
            {"timer", chart.timer},
            {"right", chart.groundTruth},
            {"same", sameJson(chart.same)},
            {"predictedFor", chart.predictedFor},
            {"leftOut", chart.leftOut},
            {"converged", convergedJson(chart)}};
}

std::string ratioText(const ChoiceCost& cost, RatioBound bound, int digits) {
    const MedianInterval& ratio = cost.ratio;
    const std::string number =
        bound == RatioBound::Unknown
            ? "-"
            : fmt::format("{}{:.{}f}", boundSign(bound), ratio.median, digits);
    const std::string interval = bound == RatioBound::Unknown
                                     ? std::string()
                                     : fmt::format("({:.{}f} .. {:.{}f}){}", ratio.lower, digits,
                                                   ratio.upper, digits, doubtOf(cost));
    return fmt::format("{:>6} {}", number, interval);
}

std::string nanosecondsText(const ChoiceCost& cost) {
    return fmt::format("{}{:.2f}", cost.belowNoise ? "<" : "", cost.nanosecondsPerPixel);
}

char doubtOf(const ChoiceCost& cost) {
    return !cost.isSure() ? '!' : cost.settled ? ' ' : '?';
}

std::string signsText(std::string_view what) {
    return fmt::format("? still unsure of 3 %; ! too few pairs for an interval; < no more than "
                       "that: it cannot be told from no time; > no less than that, and - nobody "
                       "knows: {} cannot",
                       what);
}

std::string csvText(std::string_view text) {
    std::string quoted = "\"";
    for (const char each : text) {
        quoted += each == '"' ? "\"\"" : std::string(1, each);
    }
    return quoted + '"';
}

std::string instructionsText(const std::optional<InstructionCount>& count) {
    return count ? fmt::format("{}", count->total()) : "-";
}

nlohmann::json intervalJson(const MedianInterval& interval, int samples) {
    nlohmann::json json{{"median", interval.median}, {"lower", nullptr}, {"upper", nullptr}};
    if (haveInterval(samples)) {
        json["lower"] = interval.lower;
        json["upper"] = interval.upper;
    }
    return json;
}

std::string boundsCsv(const MedianInterval& interval, int samples) {
    return haveInterval(samples) ? fmt::format("{},{}", interval.lower, interval.upper) : ",";
}

nlohmann::json countJson(const std::optional<InstructionCount>& count) {
    return count ? nlohmann::json{{"arithmetic", count->arithmetic},
                                  {"transcendental", count->transcendental},
                                  {"texture", count->texture},
                                  {"branch", count->branch},
                                  {"memory", count->memory},
                                  {"total", count->total()}}
                 : nlohmann::json();
}

} // namespace patina
