// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/json_text.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/number_text.h"

namespace patina {
namespace {

using Json = nlohmann::json;

constexpr std::size_t columns = 100;

/// Writes floats as the shortest text, which documents hold; a double that is no float (of an
/// unknown key) keeps all its digits.
std::string numberText(double value) {
    if (!std::isfinite(value)) {
        return "null";
    }
    const float narrow = static_cast<float>(value);
    const bool isFloat = static_cast<double>(narrow) == value;
    std::string text = isFloat ? shortestText(narrow) : fmt::format("{}", value);
    return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

std::string scalarText(const Json& value) {
    if (value.is_number_float()) {
        return numberText(value.get<double>());
    }
    return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

bool isWrittenAsNumber(const Json& value) {
    return value.is_number();
}
bool isScalar(const Json& value) {
    return value.is_primitive();
}

std::string onOneLine(const Json& array) {
    std::string out = "[";
    for (const Json& element : array) {
        out += (out.size() > 1 ? ", " : "") + scalarText(element);
    }
    return out + ']';
}

void write(const Json& value, std::size_t indent, std::string& out);

void writeObject(const Json& object, std::size_t indent, std::string& out) {
    const char* separator = "{\n";
    for (const auto& [key, member] : object.items()) {
        out += separator + std::string(indent + 2, ' ') + scalarText(Json(key)) + ": ";
        write(member, indent + 2, out);
        separator = ",\n";
    }
    out += '\n' + std::string(indent, ' ') + '}';
}

void writeLongArray(const Json& array, std::size_t indent, std::string& out) {
    const char* separator = "[\n";
    for (const Json& element : array) {
        out += separator + std::string(indent + 2, ' ');
        write(element, indent + 2, out);
        separator = ",\n";
    }
    out += '\n' + std::string(indent, ' ') + ']';
}

void writeArray(const Json& array, std::size_t indent, std::string& out) {
    if (std::all_of(array.begin(), array.end(), isScalar)) {
        const std::string line = onOneLine(array);
        const bool numeric = std::all_of(array.begin(), array.end(), isWrittenAsNumber);
        if (numeric || indent + line.size() < columns) {
            out += line;
            return;
        }
    }
    writeLongArray(array, indent, out);
}

void write(const Json& value, std::size_t indent, std::string& out) {
    if (value.is_primitive()) {
        out += scalarText(value);
    } else if (value.empty()) {
        out += value.is_object() ? "{}" : "[]";
    } else if (value.is_object()) {
        writeObject(value, indent, out);
    } else {
        writeArray(value, indent, out);
    }
}

} // namespace

std::string writeJson(const nlohmann::json& value) {
    std::string out;
    write(value, 0, out);
    return out + '\n';
}

} // namespace patina
