// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace patina {

/// Returns the nine spherical harmonics, up to the second order, of what a white matte surface
/// shows under a panorama (rows from the top, -z in the middle). They are factors of 1, y, z, x,
/// xy, yz, 3z^2 - 1, xz and x^2 - y^2 of its normal (Ramamoorthi and Hanrahan 2001, An Efficient
/// Representation for Irradiance Environment Maps, equations 4 and 12, over pi).
std::array<glm::vec3, 9> irradianceHarmonics(glm::ivec2 size, std::span<const glm::vec4> radiance);

} // namespace patina
