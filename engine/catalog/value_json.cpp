// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/value_json.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "catalog/json_reader.h"
#include "catalog/suggestion.h"

namespace patina {
namespace {

using Json = nlohmann::json;

tl::unexpected<Error> wrong(const Json& json, std::string expected) {
    return failure(described(json) + " stands here", std::move(expected));
}

Result<Value> number(const Json& json) {
    if (!json.is_number() || !std::isfinite(json.get<double>())) {
        return wrong(json, "a number");
    }
    return json.get<double>();
}

Result<Value> integer(const Json& json) {
    constexpr double largest = std::numeric_limits<int>::max();
    if (!json.is_number() || json.get<double>() != std::floor(json.get<double>())) {
        return wrong(json, "a whole number");
    }
    return static_cast<int>(std::clamp(json.get<double>(), -largest, largest));
}

Result<Value> boolean(const Json& json) {
    if (!json.is_boolean()) {
        return wrong(json, "true or false");
    }
    return json.get<bool>();
}

bool isNumbers(const Json& json, std::size_t count) {
    return json.is_array() && json.size() == count &&
           std::all_of(json.begin(), json.end(), [](const Json& element) {
               return element.is_number() && std::isfinite(element.get<double>());
           });
}

Result<Value> pair(const Json& json) {
    if (!isNumbers(json, 2)) {
        return wrong(json, "an array of 2 numbers");
    }
    return glm::dvec2(json[0].get<double>(), json[1].get<double>());
}

Result<Value> triple(const Json& json, const char* expected) {
    if (!isNumbers(json, 3)) {
        return wrong(json, expected);
    }
    return glm::dvec3(json[0].get<double>(), json[1].get<double>(), json[2].get<double>());
}

Result<Value> choice(const Parameter& parameter, const Json& json) {
    std::vector<std::string> ids;
    for (const EnumValue& value : parameter.values) {
        ids.push_back(value.id);
    }
    const std::string word = json.is_string() ? json.get<std::string>() : std::string();
    if (std::find(ids.begin(), ids.end(), word) == ids.end()) {
        return wrong(json, oneOf(word, ids));
    }
    return word;
}

Result<Value> text(const Json& json) {
    if (!json.is_string()) {
        return wrong(json, "text");
    }
    return json.get<std::string>();
}

} // namespace

Result<Value> valueFromJson(const Parameter& parameter, const nlohmann::json& json) {
    switch (parameter.type) {
    case ParameterType::Float:
    case ParameterType::Angle:
        return number(json);
    case ParameterType::Int:
        return integer(json);
    case ParameterType::Bool:
        return boolean(json);
    case ParameterType::Vec2:
        return pair(json);
    case ParameterType::Vec3:
        return triple(json, "an array of 3 numbers");
    case ParameterType::Color:
        return triple(json, "a colour: an array of 3 numbers, linear red, green and blue");
    case ParameterType::Enum:
        return choice(parameter, json);
    case ParameterType::Texture:
        break;
    }
    return text(json);
}

nlohmann::json toJson(const Value& value) {
    if (const auto* two = std::get_if<glm::dvec2>(&value)) {
        return {two->x, two->y};
    }
    if (const auto* three = std::get_if<glm::dvec3>(&value)) {
        return {three->x, three->y, three->z};
    }
    if (const auto* text = std::get_if<std::string>(&value)) {
        return *text;
    }
    if (const auto* flag = std::get_if<bool>(&value)) {
        return *flag;
    }
    const auto* whole = std::get_if<int>(&value);
    return whole != nullptr ? Json(*whole) : Json(std::get<double>(value));
}

} // namespace patina
