// SPDX-License-Identifier: GPL-3.0-or-later
#include "glsl_text.h"

#include <fstream>
#include <sstream>

#include <fmt/format.h>

#include "shading/glsl/tokens.h"

namespace patina {
namespace {

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

/// Returns the line with `double` for `float`. A constant is marked as maybe unused, since not
/// every translation unit needs it.
std::string cppLine(const std::string& text) {
    std::string line = text.starts_with("const ") ? "[[maybe_unused]] " : "";
    const char* done = text.data();
    for (const GlslToken& token : glslTokens(text)) {
        if (token.text == "float") {
            line.append(done, token.text.data()).append("double");
            done = token.text.data() + token.text.size();
        }
    }
    return line.append(done, text.data() + text.size());
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
    const Result<std::string> text = fileText(file);
    if (!text) {
        return tl::unexpected(text.error());
    }
    std::istringstream stream(withoutComments(*text));
    std::string line;
    for (int number = 1; std::getline(stream, line); ++number) {
        const std::string included(includedFile(line));
        if (included.empty()) {
            lines_.push_back({file.generic_string(), number, line});
        } else if (taken_.insert(included).second) {
            if (auto done = append(root_ / included); !done) {
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
