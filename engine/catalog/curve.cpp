// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/curve.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "catalog/json_reader.h"
#include "catalog/parameter.h"
#include "catalog/spaced_list.h"
#include "core/number_text.h"

namespace patina {
namespace {

using Json = nlohmann::json;

constexpr std::string_view curveWord = "curve";
/// Skips the vec4 that says whether the curve is the straight line.
constexpr std::size_t firstKnot = 4;
constexpr std::size_t knotCount = maxCurvePoints + 1; ///< counts one beyond every x, too
constexpr const char* curveForm = R"({"points": [[0, 0], [0.5, 0.7], [1, 1]]})";

using Points = SpacedList<glm::dvec2, maxCurvePoints>;

/// Returns the points that a list uses: in the range, by rising x and not too close. There are
/// fewer than two where it is no curve.
Points pointsOf(const Parameter& parameter, const NumberList& list) {
    Points all;
    if (list.type != curveWord || list.numbers.size() % 2 != 0 ||
        list.numbers.size() > 2 * maxCurvePoints) {
        return all;
    }
    for (std::size_t i = 0; i < list.numbers.size(); i += 2) {
        all.add({std::clamp(list.numbers[i], 0.0, 1.0),
                 std::clamp(list.numbers[i + 1], parameter.min, parameter.max)});
    }
    all.space(&glm::dvec2::x, minCurveGap);
    return all;
}

/// Returns the points of a value, else of the default, else of the straight line.
Points usablePoints(const Parameter& parameter, const Value& value) {
    for (const Value* given : {&value, &parameter.defaultValue}) {
        const auto* list = std::get_if<NumberList>(given);
        if (const Points points = list == nullptr ? Points() : pointsOf(parameter, *list);
            points.size() >= minCurvePoints) {
            return points;
        }
    }
    Points line;
    line.add({0.0, 0.0});
    line.add({1.0, 1.0});
    return line;
}

/// Returns the slope at a point between two others: 0 at an extremum, else the weighted harmonic
/// mean of the slopes beside it.
double slopeBetween(double left, double leftSlope, double right, double rightSlope) {
    if (leftSlope * rightSlope <= 0.0) {
        return 0.0;
    }
    const double leftWeight = 2.0 * right + left;
    const double rightWeight = right + 2.0 * left;
    return (leftWeight + rightWeight) / (leftWeight / leftSlope + rightWeight / rightSlope);
}

/// Returns the slope at an end: that of the parabola through three points, limited so that it stays
/// monotone.
double slopeAtEnd(double near, double nearSlope, double far, double farSlope) {
    const double slope = ((2.0 * near + far) * nearSlope - near * farSlope) / (near + far);
    if (slope * nearSlope <= 0.0) {
        return 0.0;
    }
    return nearSlope * farSlope <= 0.0 && std::abs(slope) > 3.0 * std::abs(nearSlope)
               ? 3.0 * nearSlope
               : slope;
}

double widthOf(std::span<const glm::dvec2> points, std::size_t i) {
    return points[i + 1].x - points[i].x;
}

double secant(std::span<const glm::dvec2> points, std::size_t i) {
    return (points[i + 1].y - points[i].y) / widthOf(points, i);
}

double slopeAt(std::span<const glm::dvec2> points, std::size_t i) {
    const std::size_t last = points.size() - 1;
    if (last == 1) {
        return secant(points, 0);
    }
    if (i == 0) {
        return slopeAtEnd(widthOf(points, 0), secant(points, 0), widthOf(points, 1),
                          secant(points, 1));
    }
    if (i == last) {
        return slopeAtEnd(widthOf(points, last - 1), secant(points, last - 1),
                          widthOf(points, last - 2), secant(points, last - 2));
    }
    return slopeBetween(widthOf(points, i - 1), secant(points, i - 1), widthOf(points, i),
                        secant(points, i));
}

/// Clamps a value to the range of two others, which rounding may have made it leave.
double between(double value, double a, double b) {
    return std::clamp(value, std::min(a, b), std::max(a, b));
}

/// Writes each piece as the control values of its Bezier form, which is a mean of them: where
/// values are 0 or more nothing cancels, and the curve never leaves them.
void writeKnots(std::span<const glm::dvec2> points, double* out) {
    out[0] = isLinear(points) ? 0.0 : 1.0;
    for (std::size_t i = 0; i < knotCount; ++i) {
        double* knot = out + firstKnot + 4 * i;
        if (i + 1 < points.size()) {
            const double third = widthOf(points, i) / 3.0;
            const double from = points[i].y;
            const double to = points[i + 1].y;
            knot[0] = points[i].x;
            knot[1] = from;
            knot[2] = between(from + third * slopeAt(points, i), from, to);
            knot[3] = between(to - third * slopeAt(points, i + 1), from, to);
        } else {
            knot[0] = i + 1 == points.size() ? points.back().x : 2.0;
            knot[1] = knot[2] = knot[3] = points.back().y;
        }
    }
}

constexpr std::string_view curveBody = R"(    x = clamp(x, 0.0, 1.0);
    int at = 1;
    at += x >= PARAMETER_DATA(at + 8).x ? 8 : 0;
    at += x >= PARAMETER_DATA(at + 4).x ? 4 : 0;
    at += x >= PARAMETER_DATA(at + 2).x ? 2 : 0;
    at += x >= PARAMETER_DATA(at + 1).x ? 1 : 0;
    vec4 from = PARAMETER_DATA(at);
    vec4 to = PARAMETER_DATA(at + 1);
    float width = max(to.x - from.x, 0.0005);
    float t = clamp((x - from.x) / width, 0.0, 1.0);
    float u = clamp((to.x - x) / width, 0.0, 1.0);
    float y = u * u * (u * from.y + 3.0 * t * from.z) + t * t * (3.0 * u * from.w + t * to.y);
    return clamp(y, min(from.y, to.y), max(from.y, to.y));
)";

// These functions fill the table's row of the type.

ValuePart curvePart(std::size_t index) {
    const std::size_t point = index / 2;
    return {fmt::format("point {}", point + 1), fmt::format("/points/{}", point)};
}

tl::expected<glm::dvec2, ValueError> pointFromJson(const CurvePoints& before, const Json& json) {
    const auto [number, pointer] = curvePart(2 * before.size());
    const std::string name = number + " of the curve";
    const bool isPoint = json.is_array() && json.size() == 2 && json[0].is_number() &&
                         json[1].is_number() && std::isfinite(json[0].get<double>()) &&
                         std::isfinite(json[1].get<double>());
    if (!isPoint) {
        return failureWithin(pointer, fmt::format("{} stands for {}", described(json), name),
                             "a point: an array of 2 numbers");
    }
    const glm::dvec2 point(json[0].get<double>(), json[1].get<double>());
    const std::string x = shortestFloatText(point.x);
    if (point.x < 0.0 || point.x > 1.0) {
        return failureWithin(pointer, fmt::format("{} has x = {}", name, x), "an x from 0 to 1");
    }
    if (!before.empty() && Points::isTooNear(before.back().x, point.x, minCurveGap)) {
        return failureWithin(
            pointer,
            fmt::format("{} has x = {} after {}", name, x, shortestFloatText(before.back().x)),
            fmt::format("an x that is {} larger or more", minCurveGap));
    }
    return point;
}

ValueReading curveFromJson(const Parameter&, const Json& json) {
    const auto list = json.is_object() && json.size() == 1 ? json.find("points") : json.end();
    if (!json.is_object() || list == json.end() || !list->is_array()) {
        return failure(described(json) + " stands here", fmt::format("a curve: {}", curveForm));
    }
    if (list->size() < minCurvePoints || list->size() > maxCurvePoints) {
        return failure(fmt::format("{} points stand here", list->size()),
                       fmt::format("{} to {} points", minCurvePoints, maxCurvePoints));
    }
    CurvePoints points;
    for (const Json& element : *list) {
        const auto point = pointFromJson(points, element);
        if (!point) {
            return tl::unexpected(point.error());
        }
        points.push_back(*point);
    }
    return curveValue(points);
}

nlohmann::json curveJson(const NumberList& list) {
    Json points = Json::array();
    for (const glm::dvec2& point : curvePoints(list)) {
        points.push_back({point.x, point.y});
    }
    return {{"points", std::move(points)}};
}

std::optional<Value> curveFromText(const Parameter& parameter, std::string_view text) {
    for (const CurvePreset& preset : curvePresets()) {
        if (preset.id == text || preset.label == text) {
            return curveValue(preset.points);
        }
    }
    if (text.starts_with('{')) {
        const Json json = Json::parse(text, nullptr, false);
        const auto value =
            json.is_discarded() ? ValueReading(failure("")) : curveFromJson(parameter, json);
        return value ? std::optional(*value) : std::nullopt;
    }
    const auto numbers = numbersIn(text);
    const bool isCurve = numbers && numbers->size() % 2 == 0 &&
                         numbers->size() >= 2 * minCurvePoints &&
                         numbers->size() <= 2 * maxCurvePoints;
    return isCurve ? std::optional<Value>(NumberList{curveWord, *numbers}) : std::nullopt;
}

std::string curveText(const NumberList& list) {
    std::string text;
    for (const glm::dvec2& point : curvePoints(list)) {
        text += fmt::format("{}{},{}", text.empty() ? "" : " ", shortestFloatText(point.x),
                            shortestFloatText(point.y));
    }
    return text;
}

std::string curveSummary(const NumberList& list) {
    const CurvePoints points = curvePoints(list);
    for (const CurvePreset& preset : curvePresets()) {
        if (roundedToFloat(curveValue(preset.points)) == roundedToFloat(list)) {
            return std::string(preset.label);
        }
    }
    return fmt::format("{} points", points.size());
}

std::string expectedCurve(const Parameter& parameter) {
    std::string words;
    for (const CurvePreset& preset : curvePresets()) {
        words += fmt::format("{}, ", preset.id);
    }
    return fmt::format("{}or {} to {} points such as \"0,0 0.5,0.7 1,1\": x from 0 to 1, each {} "
                       "larger or more, y from {} to {}",
                       words, minCurvePoints, maxCurvePoints, minCurveGap, parameter.min,
                       parameter.max);
}

Value conformedCurve(const Parameter& parameter, const Value& value) {
    const Points points = usablePoints(parameter, value);
    return curveValue(points.span());
}

void packCurve(const Parameter& parameter, const Value& value, double* out) {
    const Points points = usablePoints(parameter, value);
    std::fill_n(out, firstKnot, 0.0);
    writeKnots(points.span(), out);
}

/// Returns presets, a falling line, steep edges at both ends and in the middle, as many turns as
/// are possible, and constants.
std::vector<Value> edgeCaseCurves(const Parameter& parameter, std::span<const double> numbers) {
    std::vector<Value> values;
    for (const CurvePreset& preset : curvePresets()) {
        values.push_back(curveValue(preset.points));
    }
    const double low = parameter.min;
    const double high = parameter.max;
    const auto add = [&values](const CurvePoints& points) { values.push_back(curveValue(points)); };
    add({{0.0, high}, {1.0, low}});
    add({{0.0, low}, {minCurveGap, high}, {1.0, high}});
    add({{0.0, low}, {1.0 - minCurveGap, low}, {1.0, high}});
    add({{0.5, low}, {0.5 + minCurveGap, high}});
    CurvePoints turns;
    for (std::size_t i = 0; i < maxCurvePoints; ++i) {
        turns.push_back({static_cast<double>(i) / (maxCurvePoints - 1), i % 2 == 0 ? low : high});
    }
    add(turns);
    for (const double number : numbers) {
        add({{0.0, number}, {1.0, number}});
    }
    return values;
}

Value ordinaryCurve(const Parameter&, const std::function<double()>& next) {
    CurvePoints points;
    for (const double x : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        points.emplace_back(x, next());
    }
    return roundedToFloat(curveValue(points));
}

std::size_t curveState(const Parameter& parameter, const Value& value) {
    return isLinear(usablePoints(parameter, value).span()) ? 0 : 1;
}

ParameterTypeInfo curveInfo() {
    static constexpr ShaderFunction function{"float", curveBody, "linear", "    return x;\n"};
    ParameterTypeInfo row;
    row.word = curveWord;
    row.components = firstKnot + 4 * knotCount;
    row.glsl = "int";
    row.cpp = "const double*";
    row.needsRange = false;
    row.isAlwaysCompiled = true;
    row.fromJson = &curveFromJson;
    row.fromText = &curveFromText;
    row.expected = &expectedCurve;
    row.range = [](const Parameter& parameter) {
        return fmt::format("{} to {} points, y {} .. {}", minCurvePoints, maxCurvePoints,
                           shortestFloatText(parameter.min), shortestFloatText(parameter.max));
    };
    row.toJson = &curveJson;
    row.toText = &curveText;
    row.summary = &curveSummary;
    row.part = &curvePart;
    row.conformed = &conformedCurve;
    row.pack = &packCurve;
    row.edgeCases = &edgeCaseCurves;
    row.ordinary = &ordinaryCurve;
    row.states = [](const Parameter&) {
        return std::vector<Value>{curveValue(curvePresets()[0].points),
                                  curveValue(curvePresets()[1].points)};
    };
    row.state = &curveState;
    row.stateWord = [](const Parameter&, std::size_t state) {
        return std::string_view(state == 0 ? "linear" : "curved");
    };
    row.function = &function;
    return row;
}

} // namespace

CurvePoints curvePoints(const Value& value) {
    CurvePoints points;
    const auto* list = std::get_if<NumberList>(&value);
    if (list != nullptr && list->type == curveWord) {
        for (std::size_t i = 0; i + 1 < list->numbers.size(); i += 2) {
            points.emplace_back(list->numbers[i], list->numbers[i + 1]);
        }
    }
    return points;
}

Value curveValue(std::span<const glm::dvec2> points) {
    NumberList list{curveWord};
    list.numbers.reserve(2 * points.size());
    for (const glm::dvec2& point : points) {
        list.numbers.insert(list.numbers.end(), {point.x, point.y});
    }
    return list;
}

bool isLinear(std::span<const glm::dvec2> points) {
    return points.size() >= minCurvePoints && points.front().x == 0.0 && points.back().x == 1.0 &&
           std::ranges::all_of(points, [](const glm::dvec2& point) { return point.x == point.y; });
}

CurveShape::CurveShape(std::span<const glm::dvec2> points)
    : numbers_(firstKnot + 4 * knotCount, 0.0) {
    writeKnots(points, numbers_.data());
}

double CurveShape::at(double x) const {
    const auto knot = [this](std::size_t i) { return &numbers_[firstKnot + 4 * i]; };
    x = std::clamp(x, 0.0, 1.0);
    std::size_t i = 0;
    while (i + 2 < knotCount && x >= knot(i + 1)[0]) {
        ++i;
    }
    const double* from = knot(i);
    const double* to = knot(i + 1);
    const double t = std::clamp((x - from[0]) / (to[0] - from[0]), 0.0, 1.0);
    const double u = 1.0 - t;
    return u * u * (u * from[1] + 3.0 * t * from[2]) + t * t * (3.0 * u * from[3] + t * to[1]);
}

std::span<const CurvePreset> curvePresets() {
    static const std::array<CurvePreset, 3> presets{
        {{"linear", "Linear", {{0.0, 0.0}, {1.0, 1.0}}},
         {"ease", "Ease", {{0.0, 0.0}, {0.25, 0.15625}, {0.5, 0.5}, {0.75, 0.84375}, {1.0, 1.0}}},
         {"steps",
          "Steps",
          {{0.0, 0.0}, {0.32, 0.0}, {0.34, 0.5}, {0.66, 0.5}, {0.68, 1.0}, {1.0, 1.0}}}}};
    return presets;
}

const ParameterTypeInfo& infoOfCurve() {
    static const ParameterTypeInfo info = curveInfo();
    return info;
}

} // namespace patina
