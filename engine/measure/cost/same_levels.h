// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include "measure/cost/cost_chart.h"

namespace patina {

/// Tells whether a picture of the scene has more triangles than pixels.
bool isDense(const Scene& scene, const MeshSource& meshes, glm::ivec2 size);

/// Returns levels of the samples per pixel that the device of the current context draws alike in
/// frames of this size. It makes a target for each to find out. `dense` is as for HdrTarget.
std::vector<SameLevel> sameSampleLevels(const std::vector<Choice>& choices, glm::ivec2 size,
                                        bool dense);

/// Returns the choices without the levels that are drawn as others are.
std::vector<Choice> withoutSame(std::vector<Choice> choices, const std::vector<SameLevel>& same);

} // namespace patina
