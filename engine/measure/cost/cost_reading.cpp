// SPDX-License-Identifier: GPL-3.0-or-later
// This file reads charts of costs that costJson() wrote.
#include "measure/cost/cost_table.h"

namespace patina {
namespace {

using nlohmann::json;

/// Returns an interval; a bound that is null was not known and becomes the median.
MedianInterval intervalFrom(const json& from) {
    const double median = from.at("median").get<double>();
    const auto bound = [&](const char* name) {
        return from.at(name).is_null() ? median : from.at(name).get<double>();
    };
    return {median, bound("lower"), bound("upper")};
}

FrameError errorFrom(const json& from) {
    FrameError error;
    error.max = from.at("max").get<double>();
    error.mean = from.at("mean").get<double>();
    error.rms = from.at("rms").get<double>();
    error.p99 = from.at("p99").get<double>();
    error.stepShare = from.at("stepShare").get<double>();
    error.shown = from.at("shown").get<double>();
    error.flip = from.at("flip").get<double>();
    error.pixels = from.at("pixels").get<std::size_t>();
    return error;
}

std::optional<InstructionCount> countFrom(const json& from) {
    if (from.is_null()) {
        return std::nullopt;
    }
    return InstructionCount{from.at("arithmetic").get<int>(), from.at("transcendental").get<int>(),
                            from.at("texture").get<int>(), from.at("branch").get<int>(),
                            from.at("memory").get<int>()};
}

CostPoint pointFrom(const json& from) {
    CostPoint point;
    for (const auto& [choice, level] : from.at("levels").items()) {
        point.levels[choice] = level.get<std::string>();
    }
    point.error = errorFrom(from.at("error"));
    point.cost.ratio = intervalFrom(from.at("ratio"));
    point.cost.milliseconds = intervalFrom(from.at("milliseconds"));
    point.cost.nanosecondsPerPixel = from.at("nanosecondsPerPixel").get<double>();
    point.cost.runs = from.at("runs").get<int>();
    point.cost.settled = from.at("settled").get<bool>();
    point.cost.belowNoise = from.at("belowNoise").get<bool>();
    point.instructions = countFrom(from.at("instructions"));
    return point;
}

Choice choiceFrom(const json& from) {
    const bool isOfPicture = from.at("scope").get<std::string>() == "picture";
    Choice choice{isOfPicture ? Choice::Scope::Picture : Choice::Scope::Material,
                  from.at("id").get<std::string>(),
                  from.at("key").get<std::string>(),
                  from.at("label").get<std::string>(),
                  from.at("doc").get<std::string>(),
                  from.at("block").get<std::string>(),
                  {}};
    for (const json& level : from.at("levels")) {
        choice.levels.push_back({level.at("id").get<std::string>(),
                                 level.at("label").get<std::string>(),
                                 level.at("doc").get<std::string>()});
    }
    return choice;
}

std::optional<ConvergedRender> convergedFrom(const json& from) {
    if (from.is_null()) {
        return std::nullopt;
    }
    return ConvergedRender{from.at("choice").get<std::string>(), from.at("directions").get<int>(),
                           errorFrom(from.at("noise")), errorFrom(from.at("exact"))};
}

CostChart chartFrom(const json& from) {
    CostChart chart;
    for (const json& choice : from.at("choices")) {
        chart.choices.push_back(choiceFrom(choice));
    }
    for (const json& point : from.at("points")) {
        chart.points.push_back(pointFrom(point));
    }
    chart.size = {from.at("size").at(0).get<int>(), from.at("size").at(1).get<int>()};
    chart.pixels = from.at("pixels").get<std::size_t>();
    chart.exactMilliseconds = from.at("exactMilliseconds").get<double>();
    chart.emptyMilliseconds = from.at("emptyMilliseconds").get<double>();
    chart.timer = from.at("timer").get<std::string>();
    chart.groundTruth = from.at("right").get<std::string>();
    for (const json& each : from.at("same")) {
        chart.same.push_back({each.at("choice").get<std::string>(),
                              each.at("level").get<std::string>(), each.at("as").get<std::string>(),
                              each.at("samples").get<int>()});
    }
    chart.predictedFor = from.at("predictedFor").get<std::string>();
    chart.leftOut = from.at("leftOut").get<std::size_t>();
    chart.converged = convergedFrom(from.at("converged"));
    return chart;
}

/// Tells whether every choice has a level, and the first point, if any, is the exact one.
bool isWhole(const CostChart& chart) {
    for (const Choice& choice : chart.choices) {
        if (choice.levels.empty()) {
            return false;
        }
    }
    return chart.points.empty() || chart.points.front().isExact();
}

} // namespace

Result<CostChart> costFromJson(const json& from) {
    try {
        CostChart chart = chartFrom(from);
        if (isWhole(chart)) {
            return chart;
        }
    } catch (const json::exception& missing) {
        return failure(missing.what(), "a chart as it is exported");
    }
    return failure("the chart is not whole", "a chart as it is exported");
}

} // namespace patina
