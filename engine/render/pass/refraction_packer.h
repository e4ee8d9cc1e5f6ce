// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include <glm/vec4.hpp>

#include "render/gpu/pipeline.h"
#include "scene/scene.h"

namespace patina {

/// Writes the refraction data of a material to its `objectData`: the block's values, with the index
/// of refraction from BodyIndex, the scene's background colour, and the index for each of its
/// wavelengths. It allocates nothing once the number of wavelengths is known, unless the Fresnel
/// term works the index out.
void packRefraction(std::span<glm::vec4> out, const Pipeline& pipeline, const Material& material,
                    const Scene& scene);

} // namespace patina
