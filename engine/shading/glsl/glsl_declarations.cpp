// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/glsl/glsl_declarations.h"

#include <span>

namespace patina {
namespace {

/// Maps the index of an opening parenthesis or brace to that of the closing one, or to the end.
std::vector<std::size_t> closings(const GlslTokens& tokens, std::string_view opening,
                                  std::string_view closing) {
    std::vector<std::size_t> closedAt(tokens.size(), tokens.size());
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        if (tokens[i].text == opening) {
            open.push_back(i);
        } else if (tokens[i].text == closing && !open.empty()) {
            closedAt[open.back()] = i;
            open.pop_back();
        }
    }
    return closedAt;
}

/// Reads "type", "type name" or "OUT(type) name", with qualifiers before it and anything behind it.
GlslVariable variableOf(std::span<const GlslToken> tokens) {
    while (!tokens.empty() && isQualifier(tokens.front().text)) {
        tokens = tokens.subspan(1);
    }
    if (tokens.empty()) {
        return {};
    }
    const bool isOut = tokens.size() > 3 && tokens[0].text == "OUT" && tokens[1].text == "(";
    const std::size_t type = isOut ? 2 : 0;
    const std::size_t name = isOut ? 4 : 1;
    return {tokens[type].text, name < tokens.size() ? tokens[name].text : std::string_view(),
            isOut};
}

/// Reads the variables between separators from `first` to before `last`.
std::vector<GlslVariable> variablesOf(const GlslTokens& tokens, std::size_t first, std::size_t last,
                                      std::string_view separator) {
    std::vector<GlslVariable> variables;
    const std::span<const GlslToken> all(tokens);
    for (std::size_t i = first; i < last; ++i) {
        std::size_t end = i;
        while (end < last && tokens[end].text != separator) {
            ++end;
        }
        const GlslVariable variable = variableOf(all.subspan(i, end - i));
        if (!variable.type.empty() && variable.type != "void") {
            variables.push_back(variable);
        }
        i = end;
    }
    return variables;
}

} // namespace

std::vector<GlslFunction> functionsIn(const GlslTokens& tokens) {
    std::vector<GlslFunction> found;
    const std::vector<std::size_t> closedAt = closings(tokens, "(", ")");
    int depth = 0;
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        depth += tokens[i].text == "{" ? 1 : tokens[i].text == "}" ? -1 : 0;
        const bool isNamed = depth == 0 && i >= 1 && i + 1 < tokens.size() && tokens[i].isName() &&
                             tokens[i - 1].isName() && tokens[i + 1].text == "(";
        const std::size_t end = isNamed ? closedAt[i + 1] + 1 : 0;
        if (isNamed && end < tokens.size() && tokens[end].text == "{") {
            found.push_back(
                {tokens[i], tokens[i - 1].text, variablesOf(tokens, i + 2, end - 1, ",")});
        }
    }
    return found;
}

std::vector<GlslStruct> structsIn(const GlslTokens& tokens) {
    std::vector<GlslStruct> found;
    const std::vector<std::size_t> closedAt = closings(tokens, "{", "}");
    for (std::size_t i = 0; i + 2 < tokens.size(); ++i) {
        const bool isStruct = tokens[i].text == "struct" && tokens[i + 2].text == "{";
        if (isStruct && closedAt[i + 2] < tokens.size()) {
            found.push_back({tokens[i + 1].text, variablesOf(tokens, i + 3, closedAt[i + 2], ";")});
        }
    }
    return found;
}

} // namespace patina
