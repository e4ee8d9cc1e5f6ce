// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "core/mesh.h"

namespace patina {

/// Tells whether the vertices have texture coordinates: whether they lie at more than one place of
/// an image. A file without any leaves them all at one place, where an image is one colour. Of more
/// than a million vertices it compares about a million, evenly spaced.
bool hasImagePlaces(std::span<const Vertex> vertices);

} // namespace patina
