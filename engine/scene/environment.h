// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "catalog/block.h"
#include "material/material.h"

namespace patina {

/// The parameter that names an environment's picture; null for one that needs none.
const Parameter* pictureParameter(const Block& environment);

/// The picture that is chosen, as a path; empty for none.
std::string_view pictureFile(const BlockValues& environment, const Block& block);

/// How an environment is seen behind the objects.
enum class Backdrop { Sharp, Blurred, Hidden };

/// By the shared parameter `background`; sharp for a block without it.
Backdrop backdropOf(const BlockValues& environment, const Block& block);

/// The parameter `directions` of an environment: how many directions per pixel its light is a mean
/// of. Null for one that leaves that open.
const Parameter* directionsParameter(const Block& environment);

/// How many are wanted, at least 4; `usualDirections` where the block leaves it open.
inline constexpr int usualDirections = 1024;
int directionsOf(const BlockValues& environment, const Block& block);

/// A number of the environment's in its range, or a default: `rotate` and `background.blur` in
/// degrees. 0 for a block without it.
double environmentNumber(const BlockValues& environment, const Block& block, std::string_view id);

} // namespace patina
