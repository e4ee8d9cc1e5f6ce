// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "catalog/catalog.h"
#include "scene/scene.h"

namespace patina {

/// Returns the parameter that names an environment's picture; null for one that needs none.
const Parameter* pictureParameter(const Block& environment);

/// Returns the path of the picture that is chosen, which views into one of the arguments; empty for
/// none.
std::string_view pictureFile(const BlockValues& environment, const Block& block);

/// Tells how an environment is seen behind the objects.
enum class Backdrop { Sharp, Blurred, Hidden };

/// Returns the value of the parameter whose role is `background`; sharp for a block without one.
Backdrop backdropOf(const BlockValues& environment, const Block& block);

/// Returns the parameter that says over how many directions per pixel the light is averaged; null
/// for an environment that leaves that open.
const Parameter* directionsParameter(const Block& environment);

inline constexpr int usualDirections = 1024; ///< is used where the block leaves the number open

/// Returns how many directions per pixel are wanted, at least 4.
int directionsOf(const BlockValues& environment, const Block& block);

/// Returns how many directions a picture gets where nobody asked for a number: as many as the scene
/// wants, but at most 256, since more take long. Without an environment the number has no effect.
int unaskedDirections(const Scene& scene, const Catalog& catalog);

/// Returns the value of the number that has a role, in its range; its default where it is missing
/// or not finite, 0 for a block without one. `rotate` and `blur` are in degrees.
double environmentNumber(const BlockValues& environment, const Block& block, std::string_view role);

} // namespace patina
