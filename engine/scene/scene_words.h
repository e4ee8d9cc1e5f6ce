// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>
#include <utility>

#include "material/file_header.h"
#include "scene/scene.h"

namespace patina {

inline constexpr FileFormat sceneFormat{"patina.scene", 1, "scene"};

/// The words for tone mapping in scene files.
inline constexpr std::array<std::pair<std::string_view, ToneMapping>, 2> toneMappingWords{
    {{"none", ToneMapping::None}, {"khronosNeutral", ToneMapping::KhronosNeutral}}};

/// The words for the modes of the ground in scene files.
inline constexpr std::array<std::pair<std::string_view, GroundMode>, 3> groundModeWords{
    {{"off", GroundMode::Off}, {"shadows", GroundMode::Shadows}, {"plane", GroundMode::Plane}}};

} // namespace patina
