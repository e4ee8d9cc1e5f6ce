// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/glsl/tokens.h"

#include <algorithm>
#include <cctype>

#include "core/text.h"

namespace patina {
namespace {

/// Returns the end of the line, or of the last line that a backslash joins to it.
std::size_t directiveEnd(std::string_view text, std::size_t at) {
    std::size_t end = text.find('\n', at);
    while (end != std::string_view::npos) {
        const std::string_view line = text.substr(at, end - at);
        const std::size_t last = line.find_last_not_of('\r');
        if (last == std::string_view::npos || line[last] != '\\') {
            return end;
        }
        end = text.find('\n', end + 1);
    }
    return text.size();
}

std::size_t tokenEnd(std::string_view text, std::size_t at) {
    if (text[at] == '#') {
        return directiveEnd(text, at);
    }
    const auto end = std::find_if_not(text.begin() + static_cast<std::ptrdiff_t>(at), text.end(),
                                      isNameCharacter);
    return std::max(at + 1, static_cast<std::size_t>(end - text.begin()));
}

} // namespace

std::string withoutComments(std::string_view glsl) {
    enum class In { Code, Line, Block } in = In::Code;
    std::string out;
    out.reserve(glsl.size());
    for (std::size_t i = 0; i < glsl.size(); ++i) {
        const char c = glsl[i];
        const char next = i + 1 < glsl.size() ? glsl[i + 1] : '\0';
        const bool opens = in == In::Code && c == '/' && (next == '/' || next == '*');
        const bool closes = in == In::Block && c == '*' && next == '/';
        if (opens || closes) {
            in = closes ? In::Code : next == '/' ? In::Line : In::Block;
            out += "  ";
            ++i;
        } else if (c == '\n') {
            in = in == In::Line ? In::Code : in;
            out += c;
        } else {
            out += in == In::Code ? c : ' ';
        }
    }
    return out;
}

bool GlslToken::isName() const {
    return !text.empty() && isNameCharacter(text.front()) &&
           std::isdigit(static_cast<unsigned char>(text.front())) == 0;
}

GlslTokens glslTokens(std::string_view text) {
    GlslTokens tokens;
    tokens.reserve(text.size() / 4);
    int line = 1;
    std::size_t lineStart = 0;
    std::size_t counted = 0; // offset up to which `line` has counted newlines
    for (std::size_t at = text.find_first_not_of(" \t\r\n"); at != std::string_view::npos;
         at = text.find_first_not_of(" \t\r\n", at)) {
        for (; counted < at; ++counted) {
            if (text[counted] == '\n') {
                ++line;
                lineStart = counted + 1;
            }
        }
        const std::size_t end = tokenEnd(text, at);
        tokens.push_back({text.substr(at, end - at), line, static_cast<int>(at - lineStart) + 1});
        at = end;
    }
    return tokens;
}

GlslTokens directiveTokens(const GlslToken& directive) {
    return glslTokens(directive.text.substr(1));
}

GlslTokens opened(const GlslTokens& tokens) {
    GlslTokens all;
    all.reserve(tokens.size());
    for (const GlslToken& token : tokens) {
        if (!token.isDirective()) {
            all.push_back(token);
            continue;
        }
        const GlslTokens inside = directiveTokens(token);
        all.insert(all.end(), inside.begin(), inside.end());
    }
    return all;
}

std::string_view directiveName(const GlslToken& token) {
    const GlslTokens inside = token.isDirective() ? directiveTokens(token) : GlslTokens();
    return inside.empty() ? std::string_view() : inside.front().text;
}

std::string_view includedFile(std::string_view line) {
    const std::size_t hash = line.find_first_not_of(" \t");
    const GlslToken directive{hash == std::string_view::npos ? line : line.substr(hash)};
    if (!directiveName(directive).starts_with("include")) {
        return {};
    }
    const std::size_t open = line.find('"');
    const std::size_t close = line.find('"', open == std::string_view::npos ? open : open + 1);
    return close == std::string_view::npos ? std::string_view()
                                           : line.substr(open + 1, close - open - 1);
}

bool isPrecision(std::string_view word) {
    return word == "highp" || word == "mediump" || word == "lowp";
}

bool isQualifier(std::string_view word) {
    return word == "in" || word == "const" || word == "precise" || isPrecision(word);
}

} // namespace patina
