// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include <glm/vec4.hpp>

#include "render/gpu/pipeline.h"

namespace patina {

/// Writes the refraction data of a material to its `objectData`: the block's values, with the index
/// of refraction from bodyIndex(), and the background colour. It allocates nothing.
void packRefraction(std::span<glm::vec4> out, const Pipeline& pipeline, const Material& material,
                    const glm::dvec3& background);

} // namespace patina
