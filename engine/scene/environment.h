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

/// Tells how an environment is seen behind the objects.
enum class Backdrop { Sharp, Blurred, Hidden };

/// By the parameter whose role is `background`; sharp for a block without one.
Backdrop backdropOf(const BlockValues& environment, const Block& block);

/// The parameter that says how many directions per pixel its light is a mean of. Null for an
/// environment that leaves that open.
const Parameter* directionsParameter(const Block& environment);

/// How many are wanted, at least 4; `usualDirections` where the block leaves it open.
inline constexpr int usualDirections = 1024;
int directionsOf(const BlockValues& environment, const Block& block);

/// The number that has a role, in its range, or its default; `rotate` and `blur` are in degrees. 0
/// for a block without one.
double environmentNumber(const BlockValues& environment, const Block& block, std::string_view role);

} // namespace patina
