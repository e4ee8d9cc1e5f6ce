// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>

#include "core/mesh_material.h"

namespace patina {

/// Gives a material the look of glTF 2.0's metallic-roughness (appendix B): of its metal from a
/// half on, and of its dielectric, whose F0 is 0.04, below. The colour is linear.
void lookMetallicRough(MeshMaterial& material, const glm::dvec3& base, double metallic,
                       double roughness);

/// Gives a material the same look where an image or a share mixes metal and dielectric.
void lookMixed(MeshMaterial& material, const glm::dvec3& base, double metallic, double roughness);

} // namespace patina
