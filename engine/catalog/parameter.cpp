// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/parameter.h"

#include <algorithm>
#include <cctype>

namespace patina {
std::size_t indexOf(const std::vector<EnumValue>& values, std::string_view id) {
    const auto found = std::find_if(values.begin(), values.end(),
                                    [id](const EnumValue& value) { return value.id == id; });
    return found == values.end() ? 0 : static_cast<std::size_t>(found - values.begin());
}

int componentCount(ParameterType type) {
    return infoOf(type).components;
}

std::vector<std::string> componentNames(const Parameter& parameter) {
    if (!infoOf(parameter.type).hasAxes) {
        return {};
    }
    std::vector<std::string> names{"x", "y", "z"};
    names.resize(static_cast<std::size_t>(componentCount(parameter.type)));
    return parameter.components.size() == names.size() ? parameter.components : names;
}

Value conformed(const Parameter& parameter, const Value& value) {
    if (value.index() != parameter.defaultValue.index() || !isFinite(value)) {
        return parameter.defaultValue;
    }
    return infoOf(parameter.type).conformed(parameter, value);
}

std::string fieldName(std::string_view parameterId) {
    std::string out;
    bool capital = false;
    for (const char c : parameterId) {
        if (std::isalnum(static_cast<unsigned char>(c)) == 0) {
            capital = !out.empty();
            continue;
        }
        out += capital ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
        capital = false;
    }
    return out;
}

} // namespace patina
