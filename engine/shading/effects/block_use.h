// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "shading/effects/effect_set.h"

namespace patina {

/// A block in a program, with what of its values is compiled.
BlockUse useOf(const Block& block, const Values& values, const AccuracyLevels& levels,
               std::string reason);

} // namespace patina
