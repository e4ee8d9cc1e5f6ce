// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace patina {

/// Tells whether a line has nothing but spaces and tabs.
bool isBlank(std::string_view line);

/// Tells whether a character may stand in a name of GLSL or C++.
bool isNameCharacter(char c);

/// "fresnel" -> "Fresnel".
std::string capitalised(std::string_view word);

/// "CookTorrance" -> "COOK_TORRANCE", "diffuseColor" -> "DIFFUSE_COLOR", "v-cavity" -> "V_CAVITY".
std::string constantCase(std::string_view name);

} // namespace patina
