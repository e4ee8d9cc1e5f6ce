// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/value_json.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/number_text.h"

namespace patina {
namespace {

using Json = nlohmann::json;

struct JsonWriter {
    Json operator()(bool truth) const { return truth; }
    Json operator()(int number) const { return number; }
    Json operator()(double number) const { return number; }
    Json operator()(const glm::dvec2& v) const { return {v.x, v.y}; }
    Json operator()(const glm::dvec3& v) const { return {v.x, v.y, v.z}; }
    Json operator()(const std::string& text) const { return text; }
    Json operator()(const NumberList& list) const {
        const ParameterTypeInfo* info = infoOf(list);
        return info == nullptr ? Json(list.numbers) : info->toJson(list);
    }
};

struct TextWriter {
    std::string operator()(bool truth) const { return truth ? "true" : "false"; }
    std::string operator()(int number) const { return fmt::format("{}", number); }
    std::string operator()(double number) const { return shortestFloatText(number); }
    std::string operator()(const std::string& text) const { return text; }
    std::string operator()(const glm::dvec2& v) const {
        return fmt::format("[{}, {}]", shortestFloatText(v.x), shortestFloatText(v.y));
    }
    std::string operator()(const glm::dvec3& v) const {
        return fmt::format("[{}, {}, {}]", shortestFloatText(v.x), shortestFloatText(v.y),
                           shortestFloatText(v.z));
    }
    std::string operator()(const NumberList& list) const {
        const ParameterTypeInfo* info = infoOf(list);
        return info == nullptr ? std::string() : info->toText(list);
    }
};

} // namespace

ValueReading valueFromJson(const Parameter& parameter, const nlohmann::json& json) {
    return infoOf(parameter.type).fromJson(parameter, json);
}

ValuePart broughtIn(const Value& given, const Value& inRange) {
    const auto* before = std::get_if<NumberList>(&given);
    const auto* after = std::get_if<NumberList>(&inRange);
    if (before == nullptr || after == nullptr || infoOf(*before) == nullptr) {
        return {};
    }
    const auto [at, other] = std::ranges::mismatch(before->numbers, after->numbers);
    return at == before->numbers.end()
               ? ValuePart()
               : infoOf(*before)->part(static_cast<std::size_t>(at - before->numbers.begin()));
}

nlohmann::json toJson(const Value& value) {
    return std::visit(JsonWriter(), value);
}

std::string textOf(const Value& value) {
    return std::visit(TextWriter(), value);
}

} // namespace patina
