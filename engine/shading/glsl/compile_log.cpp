// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/glsl/compile_log.h"

#include <array>
#include <optional>
#include <regex>
#include <string>

namespace patina {
namespace {

/// Returns the forms of errors. Their groups are: source string, line, column (Mesa only), message.
const std::array<std::regex, 3>& forms() {
    static const std::array<std::regex, 3> all{
        std::regex(R"(^(\d+):(\d+)\((\d+)\): (?:preprocessor )?error: (.*)$)"),
        std::regex(R"(^(\d+)\((\d+)\)()\s*: error [A-Z]\d+: (.*)$)"),
        std::regex(R"(^ERROR: (\d+):(\d+)():\s*(.*)$)"),
    };
    return all;
}

int number(const std::string& digits) {
    return digits.empty() || digits.size() > 8 ? 0 : std::stoi(digits);
}

std::optional<Error> errorOf(const std::string& line, const ShaderSource& source) {
    std::smatch match;
    for (const std::regex& form : forms()) {
        if (std::regex_match(line, match, form)) {
            const int place = number(match[2]);
            const bool says = place >= ShaderSource::linesPerFile;
            const auto index = static_cast<std::size_t>(says ? place / ShaderSource::linesPerFile
                                                             : number(match[1]));
            const bool known = index < source.files.size();
            return Error{known ? source.files[index] : source.files.front(),
                         place % ShaderSource::linesPerFile,
                         number(match[3]),
                         match[4],
                         {}};
        }
    }
    return std::nullopt;
}

std::string trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos) {
        return "the graphics driver gave no reason";
    }
    return std::string(text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1));
}

/// Tells whether an error lists an overload: Mesa follows "no matching function" with an indented
/// line for each.
bool isOverload(const Error& error) {
    return error.problem.starts_with("  ");
}

} // namespace

Errors compileErrors(std::string_view log, const ShaderSource& source) {
    Errors errors;
    std::string_view rest = log;
    while (!rest.empty()) {
        const std::size_t end = rest.find('\n');
        auto error = errorOf(trimmed(rest.substr(0, end)), source);
        if (error && !isOverload(*error)) {
            errors.push_back(std::move(*error));
        }
        rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    }
    if (errors.empty()) {
        errors.push_back({{}, 0, 0, trimmed(log), {}});
    }
    return errors;
}

} // namespace patina
