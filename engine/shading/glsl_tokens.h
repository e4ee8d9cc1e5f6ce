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

/// The tokens of a text without comments (see withoutComments()), into which they point.
std::vector<GlslToken> glslTokens(std::string_view text);

} // namespace patina
