// SPDX-License-Identifier: GPL-3.0-or-later
#include "glsl_text.h"

#include <fstream>
#include <regex>
#include <sstream>

#include <fmt/format.h>

namespace patina {
namespace {

/// Comments become blanks; line breaks stay, so that line numbers do.
std::string withoutComments(const std::string& text) {
    std::string result = text;
    for (std::size_t i = 0; i + 1 < result.size();) {
        const std::string_view two(&result[i], 2);
        if (two != "//" && two != "/*") {
            ++i;
            continue;
        }
        const std::string_view last = two == "//" ? "\n" : "*/";
        const std::size_t found = result.find(last, i + 2);
        const std::size_t end = found == std::string::npos ? result.size()
                                : last == "\n"             ? found
                                                           : found + 2;
        for (; i < end; ++i) {
            result[i] = result[i] == '\n' ? '\n' : ' ';
        }
    }
    return result;
}

Result<std::string> fileText(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream) {
        return tl::unexpected(Error{file.string(), 0, 0, "cannot be read", {}});
    }
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

bool isBlank(const std::string& text) {
    return text.find_first_not_of(" \t\r") == std::string::npos;
}

/// A constant that one translation unit may not need.
std::string cppLine(const std::string& text) {
    static const std::regex floatWord("\\bfloat\\b");
    static const std::regex constant("^const ");
    return std::regex_replace(std::regex_replace(text, floatWord, "double"), constant,
                              "[[maybe_unused]] const ");
}

} // namespace

GlslReader::GlslReader(std::filesystem::path root, std::set<std::string> left)
    : root_(std::move(root)), taken_(std::move(left)) {}

Result<GlslLines> GlslReader::read(const std::filesystem::path& file) {
    if (const auto done = append(file); !done) {
        return tl::unexpected(done.error());
    }
    return lines_;
}

Result<void> GlslReader::append(const std::filesystem::path& file) {
    static const std::regex include("^\\s*#include\\s+\"([^\"]+)\"\\s*$");
    const Result<std::string> text = fileText(file);
    if (!text) {
        return tl::unexpected(text.error());
    }
    std::istringstream stream(withoutComments(*text));
    std::string line;
    for (int number = 1; std::getline(stream, line); ++number) {
        std::smatch match;
        if (!std::regex_match(line, match, include)) {
            lines_.push_back({file.generic_string(), number, line});
        } else if (taken_.insert(match[1]).second) {
            if (const auto done = append(root_ / match[1].str()); !done) {
                return done;
            }
        }
    }
    return {};
}

std::string asCpp(const GlslLines& lines) {
    std::string result;
    const GlslLine* last = nullptr;
    for (const GlslLine& line : lines) {
        if (isBlank(line.text)) {
            continue;
        }
        if (last == nullptr || last->file != line.file || last->number + 1 != line.number) {
            result += fmt::format("#line {} \"{}\"\n", line.number, line.file);
        }
        result += cppLine(line.text) + '\n';
        last = &line;
    }
    return result;
}

std::string asCpp(const std::string& text) {
    std::istringstream stream(text);
    std::string result;
    for (std::string line; std::getline(stream, line);) {
        result += cppLine(line) + '\n';
    }
    return result;
}

std::string plainText(const GlslLines& lines) {
    std::string result;
    for (const GlslLine& line : lines) {
        result += line.text + '\n';
    }
    return result;
}

} // namespace patina
