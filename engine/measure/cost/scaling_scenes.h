// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/scene.h"

namespace patina {

/// Returns the scene with so many lights, without shadows: those that are on, one after the other,
/// as often as it takes. A scene without any stays as it is.
Scene withLights(Scene scene, int count);

/// Returns the scene with nothing in it but so many small copies of an object, in a grid that faces
/// the camera and covers about as much of the picture as the object did.
Scene withCopies(Scene scene, std::size_t object, int count);

} // namespace patina
