// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace patina {

/// The text with every comment replaced by blanks; line numbers stay.
std::string withoutComments(std::string_view glsl);

/// A name, a number or a single sign of a GLSL text, or a whole directive from its # on, with the
/// lines that a backslash joins to it.
struct GlslToken {
    std::string_view text;
    int line = 1;
    int column = 1; ///< in bytes

    bool isDirective() const { return text.starts_with('#'); }
    bool isName() const;
};

using GlslTokens = std::vector<GlslToken>;

/// The tokens of a text without comments, into which they point.
GlslTokens glslTokens(std::string_view text);

/// Returns the tokens of a directive, behind its #.
GlslTokens directiveTokens(const GlslToken& directive);

/// The tokens with those of each directive in its place.
GlslTokens opened(const GlslTokens& tokens);

/// Returns what a directive is called: "ifdef" of "#  ifdef X"; empty for what is none.
std::string_view directiveName(const GlslToken& token);

/// The file that `#include "..."` names; empty for what is no such line.
std::string_view includedFile(std::string_view line);

/// Tells whether a word says how precise a number is.
bool isPrecision(std::string_view word);

/// Tells whether a word stands before the type of a function's argument.
bool isQualifier(std::string_view word);

} // namespace patina
