// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <glm/vec3.hpp>

namespace patina {

/// Applies the sRGB transfer curve (IEC 61966-2-1): linear -> encoded, both clamped to [0, 1].
double srgbEncoded(double linear);

/// Applies the inverse: encoded -> linear, both clamped to [0, 1].
double srgbDecoded(double encoded);

glm::dvec3 srgbEncoded(const glm::dvec3& linear);
glm::dvec3 srgbDecoded(const glm::dvec3& encoded);

/// Returns how bright a linear colour is: the Y of sRGB's primaries (IEC 61966-2-1).
double luminance(const glm::dvec3& linear);

/// Returns "#8c8c8c": a linear colour encoded as sRGB, eight bits per channel.
std::string hexOf(const glm::dvec3& linear);

/// Returns the linear colour of "#8cf", "#88ccff" or the same without "#".
std::optional<glm::dvec3> colorOfHex(std::string_view text);

} // namespace patina
