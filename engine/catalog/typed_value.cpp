// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/typed_value.h"

#include <fmt/format.h>

namespace patina {

Result<Value> valueFromText(const Parameter& parameter, std::string_view text) {
    const ParameterTypeInfo& info = infoOf(parameter.type);
    const std::optional<Value> value = info.fromText(parameter, text);
    if (value && conformed(parameter, *value) == *value) {
        return roundedToFloat(*value);
    }
    return failure(fmt::format("{}: \"{}\" is not a value for it", parameter.id, text),
                   info.expected(parameter));
}

} // namespace patina
