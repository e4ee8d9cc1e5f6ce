// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace patina {

/// Ends the names of preset files.
inline constexpr std::string_view presetSuffix = ".patina.json";

/// Ends the names of scene files.
inline constexpr std::string_view sceneSuffix = ".patina-scene.json";

} // namespace patina
