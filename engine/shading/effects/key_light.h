// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>

#include <glm/vec3.hpp>

#include "catalog/catalog.h"
#include "scene/scene.h"

namespace patina {

/// Returns the light that drawings take: of those that shine and are marked as key, or of all where
/// none is, the brightest in the middle of the objects, the first of equals. Nothing where no light
/// shines. Allocates nothing.
std::optional<std::size_t> keyLight(const Scene& scene, const Catalog& catalog);

/// Returns how bright a light is at a world point: the luminance of its colour times its intensity
/// and what distance and cone leave of it, by the roles of its parameters and its reach; finite and
/// from 0. The edge of a cone counts as hard.
double brightnessAt(const Light& light, const Block& block, const glm::dvec3& point);

} // namespace patina
