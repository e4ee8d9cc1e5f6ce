// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/program/entry_text.h"

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "catalog/table_source.h"

namespace patina {
namespace {

using TokenSpan = std::span<const GlslToken>;

/// Returns the body of a function, between its braces; empty where there is none.
TokenSpan bodyOf(TokenSpan tokens, std::string_view function) {
    int depth = 0;
    std::size_t begin = 0;
    bool isIn = false;
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        isIn = (isIn && (depth > 0 || tokens[i].text != ";")) ||
               (depth == 0 && tokens[i].text == function);
        if (tokens[i].text == "{" && depth++ == 0) {
            begin = i + 1;
        } else if (tokens[i].text == "}" && --depth == 0 && isIn) {
            return tokens.subspan(begin, i - begin);
        }
    }
    return {};
}

/// Tells whether a field is a constant of the program: the program that fills its tables has the
/// same constant.
bool isCompiled(const Block& block, std::string_view field) {
    return std::ranges::any_of(block.parameters,
                               [field](const Parameter& parameter) {
                                   return parameter.compiled == Compiled::Yes &&
                                          fieldName(parameter.id) == field;
                               }) ||
           std::ranges::any_of(block.accuracy, [field](const AccuracyChoice& choice) {
               return fieldName(choice.id) == field;
           });
}

bool names(const BlockTable& table, std::string_view field) {
    return std::ranges::any_of(table.of,
                               [field](const std::string& id) { return fieldName(id) == field; });
}

} // namespace

Errors entryMistakes(const Block& block, TokenSpan tokens) {
    Errors errors;
    for (const BlockTable& table : block.tables) {
        const TokenSpan body = bodyOf(tokens, entryFunction(block, table));
        for (std::size_t i = 0; i < body.size(); ++i) {
            const bool isParameters = body[i].text == "p" && (i == 0 || body[i - 1].text != ".");
            const bool isField = i + 2 < body.size() && body[i + 1].text == ".";
            if (!isParameters || (isField && (names(table, body[i + 2].text) ||
                                              isCompiled(block, body[i + 2].text)))) {
                continue;
            }
            const std::string read =
                isField ? fmt::format("p.{}", body[i + 2].text) : std::string("all of p");
            errors.push_back({block.shaderFile.string(), body[i].line, body[i].column,
                              fmt::format("an entry of the table \"{}\" reads {}", table.id, read),
                              "parameters that the table's \"of\" names"});
        }
    }
    return errors;
}

} // namespace patina
