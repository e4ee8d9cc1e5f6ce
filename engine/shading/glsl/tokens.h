// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace patina {

/// Returns the text with every comment replaced by blanks; line numbers stay.
std::string withoutComments(std::string_view glsl);

/// Is a name, a number or a single sign of a GLSL text, or a whole directive from its # on,
/// including the lines that a backslash joins to it.
struct GlslToken {
    std::string_view text;
    int line = 1;
    int column = 1; ///< bytes, from 1

    bool isDirective() const { return text.starts_with('#'); }
    bool isName() const;
};

using GlslTokens = std::vector<GlslToken>;

/// Returns the tokens of a text without comments. They point into the text.
GlslTokens glslTokens(std::string_view text);

/// Returns the tokens of a directive without its #.
GlslTokens directiveTokens(const GlslToken& directive);

/// Returns the tokens, with each directive replaced by its own tokens.
GlslTokens opened(const GlslTokens& tokens);

/// Returns the name of a directive: "ifdef" for "#  ifdef X"; empty for any other token.
std::string_view directiveName(const GlslToken& token);

/// Returns the file that `#include "..."` names; empty for any other line.
std::string_view includedFile(std::string_view line);

/// Tells whether a word is a precision qualifier.
bool isPrecision(std::string_view word);

/// Tells whether a word may precede the type of a function's argument.
bool isQualifier(std::string_view word);

} // namespace patina
