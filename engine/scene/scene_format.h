// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "material/file_header.h"

namespace patina {

inline constexpr FileFormat sceneFormat{"patina.scene", 1, "scene"};

} // namespace patina
