// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <glm/vec3.hpp>

namespace patina {

/// Applies the sRGB transfer curve (IEC 61966-2-1) to a linear value; both are clamped to [0, 1].
double srgbEncoded(double linear);

/// Applies the inverse of that curve to an encoded value; both are clamped to [0, 1].
double srgbDecoded(double encoded);

glm::dvec3 srgbEncoded(const glm::dvec3& linear);
glm::dvec3 srgbDecoded(const glm::dvec3& encoded);

/// Returns the luminance of a linear colour: the Y of sRGB's primaries (IEC 61966-2-1).
double luminance(const glm::dvec3& linear);

/// Returns a linear colour encoded as sRGB, eight bits per channel: "#8c8c8c".
std::string hexOf(const glm::dvec3& linear);

/// Returns the linear colour of "#8cf", "#88ccff" or the same without "#"; other text gives none.
std::optional<glm::dvec3> colorOfHex(std::string_view text);

} // namespace patina
