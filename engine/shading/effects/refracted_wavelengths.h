// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "shading/effects/data_layout.h"
#include "shading/program/block_use.h"

namespace patina {

/// Returns how many wavelengths have rays of their own; 0 where all light bends alike, and where
/// the block does not let them be chosen.
int wavelengthCount(const BlockUse& refraction);

/// Returns how many times a ray is reflected inside of a body that follows it from facet to facet;
/// 0 of a block without such a choice.
int innerReflections(const BlockUse& refraction);

/// Says where the wavelengths of a body lie in `objectData`, a vec4 for each: its shares of the
/// three channels, then the body's index for it, which is packed with the refraction.
struct WavelengthPlace {
    int first = 0;
    int count = 0;
};
std::optional<WavelengthPlace> wavelengthPlace(const ObjectLayout& layout);

} // namespace patina
