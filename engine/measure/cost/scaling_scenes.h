// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/scene.h"

namespace patina {

/// Returns the scene with so many lights without shadows: those that are on, in turn and repeated
/// as often as needed. A scene whose lights are all off gets none.
Scene withLights(Scene scene, int count);

/// Returns the scene with no other objects than so many small copies of one, in a grid that faces
/// the camera and covers about as much of the picture as the object did.
Scene withCopies(Scene scene, std::size_t object, int count);

} // namespace patina
