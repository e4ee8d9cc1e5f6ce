// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "catalog/catalog.h"
#include "scene/scene.h"

namespace patina {

/// Returns the parameter that names an environment's picture; null for one that needs none.
const Parameter* pictureParameter(const Block& environment);

/// Returns the picture that is chosen, as a path; empty for none.
std::string_view pictureFile(const BlockValues& environment, const Block& block);

/// Tells how an environment is seen behind the objects.
enum class Backdrop { Sharp, Blurred, Hidden };

/// By the parameter whose role is `background`; sharp for a block without one.
Backdrop backdropOf(const BlockValues& environment, const Block& block);

/// The parameter that says how many directions per pixel its light is a mean of. Null for an
/// environment that leaves that open.
const Parameter* directionsParameter(const Block& environment);

/// Is how many are wanted, at least 4; `usualDirections` where the block leaves it open.
inline constexpr int usualDirections = 1024;
int directionsOf(const BlockValues& environment, const Block& block);

/// Returns as many as the scene wants, but no more than a picture gets where nobody asked for a
/// number: more of them take long. Any number without an environment.
int unaskedDirections(const Scene& scene, const Catalog& catalog);

/// Returns the number that has a role, in its range, or its default; `rotate` and `blur` are in
/// degrees. 0 for a block without one.
double environmentNumber(const BlockValues& environment, const Block& block, std::string_view role);

} // namespace patina
