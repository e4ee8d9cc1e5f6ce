// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace patina {

/// Tells whether a line has nothing but spaces and tabs.
bool isBlank(std::string_view line);

/// Tells whether a character may stand in a name of GLSL or C++.
bool isNameCharacter(char c);

/// Tells whether a character is a control character of ASCII, line breaks and tabs included.
bool isControl(char c);

/// Returns the text as XML and HTML have it between tags and in quoted attributes.
std::string escapedForXml(std::string_view text);

/// Makes the first letter upper case: "fresnel" -> "Fresnel".
std::string capitalised(std::string_view word);

/// Makes "CookTorrance" -> "COOK_TORRANCE", "diffuseColor" -> "DIFFUSE_COLOR", "v-g" -> "V_G".
std::string constantCase(std::string_view name);

} // namespace patina
