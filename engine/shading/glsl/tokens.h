// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <vector>

namespace patina {

/// A name, a number or a single sign of a GLSL text, or a whole directive from its # on.
struct GlslToken {
    std::string_view text;
    int line = 1;
    int column = 1; ///< in bytes

    bool isDirective() const { return text.starts_with('#'); }
    bool isName() const;
};

using GlslTokens = std::vector<GlslToken>;

/// The tokens of a text without comments (see withoutComments()), into which they point.
GlslTokens glslTokens(std::string_view text);

/// Whether a word says how precise a number is.
bool isPrecision(std::string_view word);

/// Whether a word stands before the type of a function's argument.
bool isQualifier(std::string_view word);

} // namespace patina
