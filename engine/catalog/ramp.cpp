// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/ramp.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "catalog/json_reader.h"
#include "catalog/parameter.h"
#include "catalog/spaced_list.h"
#include "catalog/suggestion.h"
#include "core/color.h"
#include "core/number_text.h"

namespace patina {
namespace {

using Json = nlohmann::json;

constexpr std::string_view rampWord = "ramp";
constexpr std::array<std::string_view, 3> interpolationWords{"linear", "smooth", "constant"};
constexpr std::size_t numbersPerStop = 4;
constexpr std::size_t firstStop = 4;             ///< skips the vec4 that says how to interpolate
constexpr std::size_t places = maxRampStops + 1; ///< counts one beyond every x, too
constexpr const char* rampForm = R"({"stops": [{"at": 0, "color": [0, 0, 0]}, )"
                                 R"({"at": 1, "color": [1, 1, 1]}], "interpolation": "smooth"})";

struct Stops : SpacedList<RampStop, maxRampStops> {
    double interpolation = 0.0;
};

std::size_t indexOfInterpolation(double number) {
    return static_cast<std::size_t>(std::clamp(std::round(number), 0.0, 2.0));
}

/// Returns the stops that a list uses: in the range, by rising place and not too close. There are
/// none where it is no ramp.
Stops stopsOf(const Parameter& parameter, const NumberList& list) {
    Stops stops;
    const std::size_t size = list.numbers.size();
    if (list.type != rampWord || size % numbersPerStop != 1 ||
        size > 1 + numbersPerStop * maxRampStops) {
        return stops;
    }
    const auto inRange = [&parameter](double x) {
        return std::clamp(x, parameter.min, parameter.max);
    };
    for (std::size_t i = 1; i < size; i += numbersPerStop) {
        const double* stop = &list.numbers[i];
        stops.add({std::clamp(stop[0], 0.0, 1.0),
                   {inRange(stop[1]), inRange(stop[2]), inRange(stop[3])}});
    }
    stops.space(&RampStop::at, minRampGap);
    stops.interpolation = static_cast<double>(indexOfInterpolation(list.numbers.front()));
    return stops;
}

/// Returns the stops of a value, else of the default, else one that is black.
Stops usableStops(const Parameter& parameter, const Value& value) {
    for (const Value* given : {&value, &parameter.defaultValue}) {
        const auto* list = std::get_if<NumberList>(given);
        if (const Stops stops = list == nullptr ? Stops() : stopsOf(parameter, *list);
            stops.size() > 0) {
            return stops;
        }
    }
    Stops black;
    black.add({});
    return black;
}

Ramp rampOf(const Stops& stops) {
    const auto all = stops.span();
    return {static_cast<RampInterpolation>(stops.interpolation), {all.begin(), all.end()}};
}

constexpr std::string_view rampBody = R"(    x = clamp(x, 0.0, 1.0);
    int at = 1;
    at += x >= PARAMETER_DATA(at + 8).x ? 8 : 0;
    at += x >= PARAMETER_DATA(at + 4).x ? 4 : 0;
    at += x >= PARAMETER_DATA(at + 2).x ? 2 : 0;
    at += x >= PARAMETER_DATA(at + 1).x ? 1 : 0;
    vec4 from = PARAMETER_DATA(at);
    vec4 to = PARAMETER_DATA(at + 1);
    float mode = PARAMETER_DATA(0).x;
    float width = max(to.x - from.x, 0.0005);
    float t = clamp((x - from.x) / width, 0.0, 1.0);
    float u = clamp((to.x - x) / width, 0.0, 1.0);
    if (mode > 1.5) {
        u = clamp((to.x - x) * 1000.0, 0.0, 1.0);
        t = 1.0 - u;
    } else if (mode > 0.5) {
        float v = t * t * (3.0 - 2.0 * t);
        u = u * u * (3.0 - 2.0 * u);
        t = v;
    }
    return u * vec3(from.y, from.z, from.w) + t * vec3(to.y, to.z, to.w);
)";

// These functions fill the table's row of the type.

bool isFiniteNumber(const Json& json) {
    return json.is_number() && std::isfinite(json.get<double>());
}

ValuePart rampPart(std::size_t index) {
    if (index == 0) {
        return {"the interpolation", "/interpolation"};
    }
    const std::size_t stop = (index - 1) / numbersPerStop;
    return {fmt::format("stop {}", stop + 1), fmt::format("/stops/{}", stop)};
}

tl::expected<RampStop, ValueError> stopFromJson(const std::vector<RampStop>& before,
                                                const Json& json) {
    const auto [number, pointer] = rampPart(1 + numbersPerStop * before.size());
    const std::string name = number + " of the ramp";
    const auto at = json.is_object() && json.size() == 2 ? json.find("at") : json.end();
    const auto color = json.is_object() ? json.find("color") : json.end();
    if (!json.is_object() || at == json.end() || color == json.end() || !isFiniteNumber(*at) ||
        !color->is_array() || color->size() != 3 || !std::ranges::all_of(*color, isFiniteNumber)) {
        return failureWithin(
            pointer, fmt::format("{} stands for {}", described(json), name),
            R"(a stop: {"at": 0.5, "color": [0.8, 0.2, 0.1]}, linear red, green, blue)");
    }
    const RampStop stop{
        at->get<double>(),
        {(*color)[0].get<double>(), (*color)[1].get<double>(), (*color)[2].get<double>()}};
    const std::string place = shortestFloatText(stop.at);
    if (stop.at < 0.0 || stop.at > 1.0) {
        return failureWithin(pointer, fmt::format("{} is at {}", name, place),
                             "a place from 0 to 1");
    }
    if (!before.empty() && Stops::isTooNear(before.back().at, stop.at, minRampGap)) {
        return failureWithin(
            pointer,
            fmt::format("{} is at {} after {}", name, place, shortestFloatText(before.back().at)),
            fmt::format("a place that is {} further or more", minRampGap));
    }
    return stop;
}

/// Returns the interpolation of a ramp, and refuses members that a ramp does not have.
tl::expected<RampInterpolation, ValueError> interpolationFromJson(const Json& json) {
    for (const auto& [key, member] : json.items()) {
        if (key != "stops" && key != "interpolation") {
            return failureWithin('/' + escapedToken(key), fmt::format("a ramp has no \"{}\"", key),
                                 rampForm);
        }
    }
    const auto given = json.find("interpolation");
    if (given == json.end()) {
        return RampInterpolation::Linear;
    }
    const std::vector<std::string> words(interpolationWords.begin(), interpolationWords.end());
    const std::string word = given->is_string() ? given->get<std::string>() : std::string();
    const auto found = std::ranges::find(words, word);
    if (found == words.end()) {
        return failureWithin("/interpolation",
                             described(*given) + " stands for a ramp's interpolation",
                             oneOf(word, words));
    }
    return static_cast<RampInterpolation>(found - words.begin());
}

ValueReading rampFromJson(const Parameter&, const Json& json) {
    const auto list = json.is_object() ? json.find("stops") : json.end();
    if (!json.is_object() || list == json.end() || !list->is_array()) {
        return failure(described(json) + " stands here", fmt::format("a ramp: {}", rampForm));
    }
    const auto interpolation = interpolationFromJson(json);
    if (!interpolation) {
        return tl::unexpected(interpolation.error());
    }
    if (list->empty() || list->size() > maxRampStops) {
        return failure(fmt::format("{} stops stand here", list->size()),
                       fmt::format("1 to {} stops", maxRampStops));
    }
    Ramp ramp{*interpolation};
    for (const Json& element : *list) {
        const auto stop = stopFromJson(ramp.stops, element);
        if (!stop) {
            return tl::unexpected(stop.error());
        }
        ramp.stops.push_back(*stop);
    }
    return rampValue(ramp);
}

nlohmann::json rampJson(const NumberList& list) {
    const Ramp ramp = patina::rampOf(list);
    Json stops = Json::array();
    for (const RampStop& stop : ramp.stops) {
        stops.push_back({{"at", stop.at}, {"color", {stop.color.x, stop.color.y, stop.color.z}}});
    }
    return {{"interpolation", wordOf(ramp.interpolation)}, {"stops", std::move(stops)}};
}

/// Parses a stop: "0.5:#ff8800" or "0.5:0.8,0.2,0.1".
std::optional<RampStop> stopFromText(std::string_view text) {
    const std::size_t colon = text.find(':');
    if (colon == std::string_view::npos) {
        return std::nullopt;
    }
    const std::optional<double> at = parseNumber(text.substr(0, colon));
    const std::string_view rest = text.substr(colon + 1);
    std::optional<glm::dvec3> color;
    if (rest.starts_with('#')) {
        color = colorOfHex(rest);
    } else if (const auto numbers = numbersIn(rest); numbers && numbers->size() == 3) {
        color = glm::dvec3((*numbers)[0], (*numbers)[1], (*numbers)[2]);
    }
    return at && color ? std::optional(RampStop{*at, *color}) : std::nullopt;
}

std::optional<Value> rampFromWords(std::string_view text) {
    Ramp ramp;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(' '), text.size());
        const std::string_view word = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        if (word.empty()) {
            continue;
        }
        const auto known = std::ranges::find(interpolationWords, word);
        const std::optional<RampStop> stop = stopFromText(word);
        if (known != interpolationWords.end()) {
            ramp.interpolation = static_cast<RampInterpolation>(known - interpolationWords.begin());
        } else if (stop && ramp.stops.size() < maxRampStops) {
            ramp.stops.push_back(*stop);
        } else {
            return std::nullopt;
        }
    }
    return ramp.stops.empty() ? std::nullopt : std::optional(rampValue(ramp));
}

std::optional<Value> rampFromText(const Parameter& parameter, std::string_view text) {
    if (!text.starts_with('{')) {
        return rampFromWords(text);
    }
    const Json json = Json::parse(text, nullptr, false);
    const auto value =
        json.is_discarded() ? ValueReading(failure("")) : rampFromJson(parameter, json);
    return value ? std::optional(*value) : std::nullopt;
}

std::string rampText(const NumberList& list) {
    const Ramp ramp = patina::rampOf(list);
    std::string text(wordOf(ramp.interpolation));
    for (const RampStop& stop : ramp.stops) {
        text +=
            fmt::format(" {}:{},{},{}", shortestFloatText(stop.at), shortestFloatText(stop.color.x),
                        shortestFloatText(stop.color.y), shortestFloatText(stop.color.z));
    }
    return text;
}

std::string rampSummary(const NumberList& list) {
    const Ramp ramp = patina::rampOf(list);
    return fmt::format("{} {}, {}", ramp.stops.size(), ramp.stops.size() == 1 ? "stop" : "stops",
                       wordOf(ramp.interpolation));
}

std::string expectedRamp(const Parameter& parameter) {
    return fmt::format("1 to {} stops such as \"smooth 0:#203040 1:0.9,0.8,0.7\": places from 0 to "
                       "1, each {} further or more, colours {} .. {}; linear, smooth or constant",
                       maxRampStops, minRampGap, parameter.min, parameter.max);
}

Value conformedRamp(const Parameter& parameter, const Value& value) {
    return rampValue(rampOf(usableStops(parameter, value)));
}

void packRamp(const Parameter& parameter, const Value& value, double* out) {
    const Stops stops = usableStops(parameter, value);
    std::fill_n(out, firstStop, 0.0);
    out[0] = stops.interpolation;
    for (std::size_t i = 0; i < places; ++i) {
        const RampStop& stop = stops.span()[std::min(i, stops.size() - 1)];
        double* place = out + firstStop + numbersPerStop * i;
        place[0] = i < stops.size() ? stop.at : 2.0;
        std::copy_n(&stop.color.x, 3, place + 1);
    }
}

/// Returns ramps of one colour, of both ends, with edges and with as many stops as are possible,
/// the latter three in every interpolation.
std::vector<Value> edgeCaseRamps(const Parameter& parameter, std::span<const double> numbers) {
    const glm::dvec3 low(parameter.min);
    const glm::dvec3 high(parameter.max);
    std::vector<RampStop> turns;
    for (std::size_t i = 0; i < maxRampStops; ++i) {
        turns.push_back({static_cast<double>(i) / (maxRampStops - 1), i % 2 == 0 ? low : high});
    }
    std::vector<Value> values;
    for (const RampInterpolation interpolation :
         {RampInterpolation::Linear, RampInterpolation::Smooth, RampInterpolation::Constant}) {
        values.push_back(rampValue({interpolation, {{0.0, low}, {1.0, high}}}));
        values.push_back(rampValue({interpolation, {{0.5, high}, {0.5 + minRampGap, low}}}));
        values.push_back(rampValue({interpolation, turns}));
    }
    for (const double number : numbers) {
        values.push_back(rampValue({RampInterpolation::Linear, {{0.0, glm::dvec3(number)}}}));
    }
    return values;
}

Value ordinaryRamp(const Parameter&, const std::function<double()>& next) {
    Ramp ramp{RampInterpolation::Smooth};
    for (const double at : {0.0, 0.3, 0.6, 1.0}) {
        const double red = next();
        const double green = next();
        ramp.stops.push_back({at, {red, green, next()}});
    }
    return roundedToFloat(rampValue(ramp));
}

ParameterTypeInfo rampInfo() {
    static constexpr ShaderFunction function{"vec3", rampBody, "", ""};
    ParameterTypeInfo row;
    row.word = rampWord;
    row.components = firstStop + numbersPerStop * places;
    row.glsl = "int";
    row.cpp = "const double*";
    row.needsRange = false;
    row.fromJson = &rampFromJson;
    row.fromText = &rampFromText;
    row.expected = &expectedRamp;
    row.range = [](const Parameter& parameter) {
        return fmt::format("1 to {} stops, colours {} .. {}", maxRampStops,
                           shortestFloatText(parameter.min), shortestFloatText(parameter.max));
    };
    row.toJson = &rampJson;
    row.toText = &rampText;
    row.summary = &rampSummary;
    row.part = &rampPart;
    row.conformed = &conformedRamp;
    row.pack = &packRamp;
    row.edgeCases = &edgeCaseRamps;
    row.ordinary = &ordinaryRamp;
    row.function = &function;
    return row;
}

} // namespace

glm::dvec3 Ramp::at(double x) const {
    if (stops.empty()) {
        return glm::dvec3(0.0);
    }
    const auto next = std::ranges::upper_bound(stops, x, {}, &RampStop::at);
    if (next == stops.begin() || next == stops.end()) {
        return next == stops.begin() ? stops.front().color : stops.back().color;
    }
    const RampStop& from = *(next - 1);
    double t = (x - from.at) / (next->at - from.at);
    if (interpolation == RampInterpolation::Smooth) {
        t = t * t * (3.0 - 2.0 * t);
    } else if (interpolation == RampInterpolation::Constant) {
        t = 1.0 - std::clamp((next->at - x) / minRampGap, 0.0, 1.0);
    }
    return (1.0 - t) * from.color + t * next->color;
}

Ramp rampOf(const Value& value) {
    Ramp ramp;
    const auto* list = std::get_if<NumberList>(&value);
    if (list == nullptr || list->type != rampWord || list->numbers.empty()) {
        return ramp;
    }
    const std::vector<double>& n = list->numbers;
    ramp.interpolation = static_cast<RampInterpolation>(indexOfInterpolation(n.front()));
    for (std::size_t i = 1; i + 3 < n.size(); i += numbersPerStop) {
        ramp.stops.push_back({n[i], {n[i + 1], n[i + 2], n[i + 3]}});
    }
    return ramp;
}

Value rampValue(const Ramp& ramp) {
    NumberList list{rampWord, {static_cast<double>(ramp.interpolation)}};
    list.numbers.reserve(1 + numbersPerStop * ramp.stops.size());
    for (const RampStop& stop : ramp.stops) {
        list.numbers.insert(list.numbers.end(),
                            {stop.at, stop.color.x, stop.color.y, stop.color.z});
    }
    return list;
}

std::string_view wordOf(RampInterpolation interpolation) {
    return interpolationWords[static_cast<std::size_t>(interpolation)];
}

const ParameterTypeInfo& infoOfRamp() {
    static const ParameterTypeInfo info = rampInfo();
    return info;
}

} // namespace patina
