// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "catalog/block.h"
#include "scene/scene.h"

namespace patina {

/// Returns a sentence, with a space before it, where a chosen spectrum of the block has no number
/// for a wavelength of the scene; else an empty text.
std::string spectralRangeNote(const Block& block, const Values& values, const Scene& scene);

} // namespace patina
