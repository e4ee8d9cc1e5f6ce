// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include <glm/vec4.hpp>

#include "render/gpu/pipeline.h"

namespace patina {

/// Adds to the `objectData` of a material that refracts light what its program knows of that: the
/// block's values with the index that counts, and the colour behind the objects. Allocates nothing.
void packRefraction(std::span<glm::vec4> out, const Pipeline& pipeline, const Material& material,
                    const glm::dvec3& background);

} // namespace patina
