// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/parameter_type.h"

#include <algorithm>
#include <array>

#include "catalog/parameter.h"
#include "core/number_text.h"

namespace patina {
namespace {

#define PATINA_TYPE(name) ParameterType::name,
constexpr std::array allTypes{PATINA_PARAMETER_TYPES(PATINA_TYPE)};
#undef PATINA_TYPE

std::string_view withoutBrackets(std::string_view text) {
    constexpr std::string_view around = "[]() \t\r\n";
    const std::size_t first = text.find_first_not_of(around);
    return first == std::string_view::npos
               ? std::string_view()
               : text.substr(first, text.find_last_not_of(around) - first + 1);
}

} // namespace

const ParameterTypeInfo& infoOf(ParameterType type) {
#define PATINA_ROW(name) &infoOf##name(),
    static const std::array<const ParameterTypeInfo*, allTypes.size()> rows{
        PATINA_PARAMETER_TYPES(PATINA_ROW)};
#undef PATINA_ROW
    return *rows[static_cast<std::size_t>(type)];
}

std::span<const ParameterType> parameterTypes() {
    return allTypes;
}

std::optional<ParameterType> parameterTypeOf(std::string_view word) {
    const auto found = std::ranges::find_if(
        allTypes, [word](ParameterType type) { return infoOf(type).word == word; });
    return found == allTypes.end() ? std::nullopt : std::optional(*found);
}

const ParameterTypeInfo* infoOf(const NumberList& list) {
    const std::optional<ParameterType> type = parameterTypeOf(list.type);
    return type ? &infoOf(*type) : nullptr;
}

void writeNumbers(const Parameter& parameter, const Value& value, double* out) {
    const Value& fallback = parameter.defaultValue;
    const bool isUsable = value.index() == fallback.index() && isFinite(value);
    infoOf(parameter.type).pack(parameter, isUsable ? value : fallback, out);
}

std::optional<std::vector<double>> numbersIn(std::string_view text) {
    std::string separated(withoutBrackets(text));
    std::ranges::replace(separated, ',', ' ');
    std::vector<double> numbers;
    for (std::string_view rest = separated; !rest.empty();) {
        const std::size_t end = std::min(rest.find_first_of(" \t"), rest.size());
        const std::optional<double> number = parseNumber(rest.substr(0, end));
        if (!number) {
            return std::nullopt;
        }
        numbers.push_back(*number);
        rest.remove_prefix(end);
        rest.remove_prefix(std::min(rest.find_first_not_of(" \t"), rest.size()));
    }
    return numbers;
}

} // namespace patina
