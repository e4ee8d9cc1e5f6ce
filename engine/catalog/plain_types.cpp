// SPDX-License-Identifier: GPL-3.0-or-later
// This file has the rows of types whose values are one to three numbers, a bool, a choice or a
// file.
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <glm/trigonometric.hpp>
#include <nlohmann/json.hpp>

#include "catalog/json_reader.h"
#include "catalog/parameter.h"
#include "catalog/suggestion.h"
#include "core/color.h"
#include "core/number_text.h"

namespace patina {
namespace {

using Json = nlohmann::json;
using Numbers = std::span<const double>;
using Next = std::function<double()>;

tl::unexpected<Error> wrong(const Json& json, std::string expected) {
    return failure(described(json) + " stands here", std::move(expected));
}

bool areNumbers(const Json& json, std::size_t count) {
    return json.is_array() && json.size() == count &&
           std::all_of(json.begin(), json.end(), [](const Json& element) {
               return element.is_number() && std::isfinite(element.get<double>());
           });
}

/// Clamps to the range. A number that rounds to the same float as an end of it, as 0.01 read back
/// from a float does, stays as it is.
double clampedNumber(const Parameter& parameter, double x) {
    const double near = std::clamp(x, parameter.min, parameter.max);
    const bool sameFloat = static_cast<float>(near) == static_cast<float>(x);
    return sameFloat && near != 0.0 ? x : near; // nothing beyond 0, which has its own sign
}

std::string limitsText(const Parameter& parameter) {
    return fmt::format("{} .. {}", parameter.min, parameter.max);
}

/// Returns the range as lists show it, with the unit and the names of the components.
std::string listedRange(const Parameter& parameter) {
    const std::vector<std::string>& names = parameter.components;
    return fmt::format("{} .. {}{}{}{}", shortestFloatText(parameter.min),
                       shortestFloatText(parameter.max), parameter.unit.empty() ? "" : " ",
                       parameter.unit,
                       names.empty() ? "" : fmt::format(" ({})", fmt::join(names, ", ")));
}

// Float and angle

ValueReading numberFromJson(const Parameter&, const Json& json) {
    if (!json.is_number() || !std::isfinite(json.get<double>())) {
        return wrong(json, "a number");
    }
    return json.get<double>();
}

std::optional<Value> numberFromText(const Parameter&, std::string_view text) {
    const auto numbers = numbersIn(text);
    return numbers && numbers->size() == 1 ? std::optional<Value>(numbers->front()) : std::nullopt;
}

std::string expectedNumber(const Parameter& parameter) {
    return "a number, " + limitsText(parameter);
}

Value conformedNumber(const Parameter& parameter, const Value& value) {
    return clampedNumber(parameter, std::get<double>(value));
}

void packNumber(const Parameter& parameter, const Value& value, double* out) {
    *out = clampedNumber(parameter, std::get<double>(value));
}

void packAngle(const Parameter& parameter, const Value& value, double* out) {
    *out = glm::radians(clampedNumber(parameter, std::get<double>(value)));
}

std::vector<Value> edgeCaseNumbers(const Parameter&, Numbers numbers) {
    return {numbers.begin(), numbers.end()};
}

Value ordinaryNumber(const Parameter&, const Next& next) {
    return roundedToFloat(next());
}

ParameterTypeInfo numberInfo() {
    ParameterTypeInfo info;
    info.fromJson = &numberFromJson;
    info.fromText = &numberFromText;
    info.expected = &expectedNumber;
    info.range = &listedRange;
    info.conformed = &conformedNumber;
    info.pack = &packNumber;
    info.edgeCases = &edgeCaseNumbers;
    info.ordinary = &ordinaryNumber;
    return info;
}

// Int

ValueReading wholeFromJson(const Parameter&, const Json& json) {
    constexpr double largest = std::numeric_limits<int>::max();
    if (!json.is_number() || json.get<double>() != std::floor(json.get<double>())) {
        return wrong(json, "a whole number");
    }
    return static_cast<int>(std::clamp(json.get<double>(), -largest, largest));
}

std::optional<Value> wholeFromText(const Parameter&, std::string_view text) {
    constexpr double largest = std::numeric_limits<int>::max();
    const auto numbers = numbersIn(text);
    const bool isWhole = numbers && numbers->size() == 1 && std::abs(numbers->front()) <= largest &&
                         std::trunc(numbers->front()) == numbers->front();
    return isWhole ? std::optional<Value>(static_cast<int>(numbers->front())) : std::nullopt;
}

std::string expectedWhole(const Parameter& parameter) {
    return "a whole number, " + limitsText(parameter);
}

int clampedWhole(const Parameter& parameter, const Value& value) {
    return static_cast<int>(std::clamp<double>(std::get<int>(value), std::ceil(parameter.min),
                                               std::floor(parameter.max)));
}

Value conformedWhole(const Parameter& parameter, const Value& value) {
    return clampedWhole(parameter, value);
}

void packWhole(const Parameter& parameter, const Value& value, double* out) {
    *out = clampedWhole(parameter, value);
}

std::vector<Value> edgeCaseWholes(const Parameter&, Numbers numbers) {
    std::vector<Value> values;
    for (const double number : numbers) {
        values.emplace_back(static_cast<int>(std::ceil(number)));
    }
    return values;
}

Value ordinaryWhole(const Parameter& parameter, const Next& next) {
    return conformed(parameter, static_cast<int>(std::round(next())));
}

// Bool

ValueReading truthFromJson(const Parameter&, const Json& json) {
    if (!json.is_boolean()) {
        return wrong(json, "true or false");
    }
    return json.get<bool>();
}

std::optional<Value> truthFromText(const Parameter&, std::string_view text) {
    const bool truth = text == "true" || text == "yes" || text == "on" || text == "1";
    const bool lie = text == "false" || text == "no" || text == "off" || text == "0";
    return truth || lie ? std::optional<Value>(truth) : std::nullopt;
}

Value sameValue(const Parameter&, const Value& value) {
    return value;
}

void packTruth(const Parameter&, const Value& value, double* out) {
    *out = std::get<bool>(value) ? 1.0 : 0.0;
}

std::vector<Value> bothTruths(const Parameter&) {
    return {false, true};
}

// Vectors and colours

template <class Vector>
constexpr std::size_t sizeOf = static_cast<std::size_t>(Vector::length());

template <class Vector>
Vector vectorOf(Numbers numbers) {
    Vector vector(0.0);
    for (std::size_t i = 0; i < sizeOf<Vector>; ++i) {
        vector[static_cast<int>(i)] = numbers[i];
    }
    return vector;
}

template <class Vector>
ValueReading vectorFromJson(const Parameter& parameter, const Json& json) {
    if (!areNumbers(json, sizeOf<Vector>)) {
        return wrong(json, infoOf(parameter.type).isColor
                               ? "a colour: an array of 3 numbers, linear red, green and blue"
                               : fmt::format("an array of {} numbers", sizeOf<Vector>));
    }
    return vectorOf<Vector>(json.get<std::vector<double>>());
}

template <class Vector>
std::optional<Value> vectorFromText(const Parameter&, std::string_view text) {
    const auto numbers = numbersIn(text);
    return numbers && numbers->size() == sizeOf<Vector>
               ? std::optional<Value>(vectorOf<Vector>(*numbers))
               : std::nullopt;
}

std::optional<Value> colorFromText(const Parameter& parameter, std::string_view text) {
    const auto color = text.starts_with('#') ? colorOfHex(text) : std::nullopt;
    return color ? std::optional<Value>(*color) : vectorFromText<glm::dvec3>(parameter, text);
}

std::string expectedVector(const Parameter& parameter) {
    return fmt::format("{} numbers with commas, {} each", componentCount(parameter.type),
                       limitsText(parameter));
}

std::string expectedColor(const Parameter& parameter) {
    return fmt::format("three linear numbers such as 0.8,0.2,0.1 ({} each) or #rrggbb",
                       limitsText(parameter));
}

template <class Vector>
void packVector(const Parameter& parameter, const Value& value, double* out) {
    const auto& vector = std::get<Vector>(value);
    for (std::size_t i = 0; i < sizeOf<Vector>; ++i) {
        out[i] = clampedNumber(parameter, vector[static_cast<int>(i)]);
    }
}

template <class Vector>
Value conformedVector(const Parameter& parameter, const Value& value) {
    std::array<double, sizeOf<Vector>> numbers{};
    packVector<Vector>(parameter, value, numbers.data());
    return vectorOf<Vector>(numbers);
}

/// Returns vectors of equal components, and mixtures of the ends with what is between.
template <class Vector>
std::vector<Value> edgeCaseVectors(const Parameter&, Numbers numbers) {
    std::vector<Value> values;
    for (const double number : numbers) {
        values.emplace_back(Vector(number));
    }
    for (std::size_t i = 0; i + 2 < std::min<std::size_t>(numbers.size(), 8); ++i) {
        Vector mixed(numbers[i + 2]);
        mixed[0] = numbers[i];
        mixed[1] = numbers[i + 1];
        values.emplace_back(mixed);
    }
    return values;
}

template <class Vector>
Value ordinaryVector(const Parameter&, const Next& next) {
    std::array<double, sizeOf<Vector>> numbers{};
    std::ranges::generate(numbers, next);
    return roundedToFloat(vectorOf<Vector>(numbers));
}

template <class Vector>
ParameterTypeInfo vectorInfo(std::string_view word) {
    ParameterTypeInfo info;
    info.word = word;
    info.hasAxes = true;
    info.components = Vector::length();
    info.glsl = info.cpp = Vector::length() == 2 ? "vec2" : "vec3";
    info.fromJson = &vectorFromJson<Vector>;
    info.fromText = &vectorFromText<Vector>;
    info.expected = &expectedVector;
    info.range = &listedRange;
    info.conformed = &conformedVector<Vector>;
    info.pack = &packVector<Vector>;
    info.edgeCases = &edgeCaseVectors<Vector>;
    info.ordinary = &ordinaryVector<Vector>;
    return info;
}

// Enum

std::vector<std::string> idsOf(const Parameter& parameter) {
    std::vector<std::string> ids;
    for (const EnumValue& value : parameter.values) {
        ids.push_back(value.id);
    }
    return ids;
}

ValueReading choiceFromJson(const Parameter& parameter, const Json& json) {
    const std::vector<std::string> ids = idsOf(parameter);
    const std::string word = json.is_string() ? json.get<std::string>() : std::string();
    if (std::find(ids.begin(), ids.end(), word) == ids.end()) {
        return wrong(json, oneOf(word, ids));
    }
    return word;
}

std::optional<Value> choiceFromText(const Parameter& parameter, std::string_view text) {
    for (const EnumValue& value : parameter.values) {
        if (value.id == text || value.label == text) {
            return value.id;
        }
    }
    return std::nullopt;
}

std::size_t chosenIndex(const Parameter& parameter, const Value& value) {
    const auto isChosen = [&](const Value& wanted) {
        return std::ranges::find(parameter.values, std::get<std::string>(wanted), &EnumValue::id);
    };
    const auto found = isChosen(value);
    const auto chosen = found == parameter.values.end() ? isChosen(parameter.defaultValue) : found;
    return chosen == parameter.values.end()
               ? 0
               : static_cast<std::size_t>(chosen - parameter.values.begin());
}

Value conformedChoice(const Parameter& parameter, const Value& value) {
    const bool isKnown = std::ranges::find(parameter.values, std::get<std::string>(value),
                                           &EnumValue::id) != parameter.values.end();
    return isKnown ? value : parameter.defaultValue;
}

void packChoice(const Parameter& parameter, const Value& value, double* out) {
    *out = static_cast<double>(chosenIndex(parameter, value));
}

std::vector<Value> allChoices(const Parameter& parameter) {
    const std::vector<std::string> ids = idsOf(parameter);
    return {ids.begin(), ids.end()};
}

// Texture

ValueReading fileFromJson(const Parameter&, const Json& json) {
    if (!json.is_string()) {
        return wrong(json, "text");
    }
    return json.get<std::string>();
}

/// Returns the full path of a file that is named on the command line.
std::optional<Value> pathFromText(const Parameter&, std::string_view text) {
    return text.empty() ? Value(std::string())
                        : Value(std::filesystem::absolute(std::filesystem::path(text))
                                    .lexically_normal()
                                    .string());
}

} // namespace

const ParameterTypeInfo& infoOfFloat() {
    static const ParameterTypeInfo info = [] {
        ParameterTypeInfo row = numberInfo();
        row.word = "float";
        row.needsRange = false;
        row.takesImage = true;
        return row;
    }();
    return info;
}

const ParameterTypeInfo& infoOfAngle() {
    static const ParameterTypeInfo info = [] {
        ParameterTypeInfo row = numberInfo();
        row.word = "angle";
        row.step = 1.0;
        row.decimals = 1;
        row.unit = "\u00b0";
        row.pack = &packAngle;
        row.isAngle = true;
        return row;
    }();
    return info;
}

const ParameterTypeInfo& infoOfInt() {
    static const ParameterTypeInfo info = [] {
        ParameterTypeInfo row = numberInfo();
        row.word = "int";
        row.glsl = row.cpp = "int";
        row.isContinuous = false;
        row.step = 1.0;
        row.decimals = 0;
        row.fromJson = &wholeFromJson;
        row.fromText = &wholeFromText;
        row.expected = &expectedWhole;
        row.conformed = &conformedWhole;
        row.pack = &packWhole;
        row.edgeCases = &edgeCaseWholes;
        row.ordinary = &ordinaryWhole;
        row.isWhole = true;
        return row;
    }();
    return info;
}

const ParameterTypeInfo& infoOfBool() {
    static const ParameterTypeInfo info = [] {
        ParameterTypeInfo row;
        row.word = "bool";
        row.glsl = row.cpp = "bool";
        row.hasRange = row.isContinuous = false;
        row.fromJson = &truthFromJson;
        row.fromText = &truthFromText;
        row.expected = [](const Parameter&) { return std::string("true or false"); };
        row.range = [](const Parameter&) { return std::string("true | false"); };
        row.conformed = &sameValue;
        row.pack = &packTruth;
        row.edgeCases = [](const Parameter& parameter, Numbers) { return bothTruths(parameter); };
        row.ordinary = [](const Parameter&, const Next& next) { return Value(next() >= 0.5); };
        row.states = &bothTruths;
        row.state = [](const Parameter&, const Value& value) -> std::size_t {
            return std::get<bool>(value) ? 1 : 0;
        };
        row.stateWord = [](const Parameter&, std::size_t state) {
            return std::string_view(state == 0 ? "false" : "true");
        };
        return row;
    }();
    return info;
}

const ParameterTypeInfo& infoOfVec2() {
    static const ParameterTypeInfo info = vectorInfo<glm::dvec2>("vec2");
    return info;
}

const ParameterTypeInfo& infoOfVec3() {
    static const ParameterTypeInfo info = vectorInfo<glm::dvec3>("vec3");
    return info;
}

const ParameterTypeInfo& infoOfColor() {
    static const ParameterTypeInfo info = [] {
        ParameterTypeInfo row = vectorInfo<glm::dvec3>("color");
        row.needsRange = false;
        row.fromText = &colorFromText;
        row.expected = &expectedColor;
        row.isColor = row.takesImage = true;
        row.hasAxes = false;
        return row;
    }();
    return info;
}

const ParameterTypeInfo& infoOfEnum() {
    static const ParameterTypeInfo info = [] {
        ParameterTypeInfo row;
        row.word = "enum";
        row.glsl = row.cpp = "int";
        row.hasRange = row.isContinuous = false;
        row.fromJson = &choiceFromJson;
        row.fromText = &choiceFromText;
        row.expected = [](const Parameter& parameter) {
            return fmt::format("one of {}", fmt::join(idsOf(parameter), ", "));
        };
        row.range = [](const Parameter& parameter) {
            return fmt::format("{}", fmt::join(idsOf(parameter), " | "));
        };
        row.conformed = &conformedChoice;
        row.pack = &packChoice;
        row.edgeCases = [](const Parameter& parameter, Numbers) { return allChoices(parameter); };
        row.ordinary = [](const Parameter& parameter, const Next& next) -> Value {
            const double share = std::clamp(next(), 0.0, 0.999);
            const auto count = static_cast<double>(parameter.values.size());
            return parameter.values[static_cast<std::size_t>(share * count)].id;
        };
        row.states = &allChoices;
        row.state = &chosenIndex;
        row.stateWord = [](const Parameter& parameter, std::size_t state) {
            return state < parameter.values.size() ? std::string_view(parameter.values[state].id)
                                                   : std::string_view();
        };
        row.isChoice = true;
        return row;
    }();
    return info;
}

const ParameterTypeInfo& infoOfTexture() {
    static const ParameterTypeInfo info = [] {
        ParameterTypeInfo row;
        row.word = "texture";
        row.components = 0;
        row.hasRange = row.isContinuous = false;
        row.fromJson = &fileFromJson;
        row.fromText = &pathFromText;
        row.expected = [](const Parameter&) { return std::string("a file"); };
        row.range = [](const Parameter&) { return std::string("a file"); };
        row.conformed = &sameValue;
        row.pack = [](const Parameter&, const Value&, double*) {};
        row.edgeCases = [](const Parameter&, Numbers) { return std::vector<Value>(); };
        row.ordinary = [](const Parameter& parameter, const Next&) {
            return parameter.defaultValue;
        };
        row.isFile = true;
        return row;
    }();
    return info;
}

} // namespace patina
