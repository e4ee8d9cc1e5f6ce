// SPDX-License-Identifier: GPL-3.0-or-later
#include "number_mover.h"

#include <fmt/format.h>

namespace patina {

std::string cppType(const std::string& type) {
    return type == "float" ? "double" : type;
}

std::string NumberMover::move(const std::string& type, const std::string& place, bool reading) {
    std::string text;
    if (const StructDeclaration* declared = declarations_.findStruct(type)) {
        for (const Variable& field : declared->fields) {
            text += move(field.type, place + '.' + field.name, reading);
        }
        return text;
    }
    const std::size_t count = declarations_.numbers(type);
    if (count == 1) {
        return scalar(type, place, reading);
    }
    for (std::size_t i = 0; i < count; ++i) {
        text += scalar("float", fmt::format("{}[{}]", place, i), reading);
    }
    return text;
}

std::string NumberMover::scalar(const std::string& type, const std::string& place, bool reading) {
    const std::size_t at = cursor_++;
    const bool cpp = language_ == Language::Cpp;
    if (!reading) {
        return cpp ? fmt::format("out[{}] = double({}); ", at, place)
                   : fmt::format("RESULT({}, float({})); ", at, place);
    }
    return cpp ? fmt::format("{} = {}(in[{}]); ", place, cppType(type), at)
               : fmt::format("{} = {}(ARGUMENT({})); ", place, type, at);
}

} // namespace patina
