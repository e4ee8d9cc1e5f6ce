// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace patina {

// These follow the word of an image in MeshMaterial::values and say how it lies, as
// KHR_texture_transform does: coordinates that begin at the top are scaled, turned by radians,
// moved.
inline constexpr const char* imageScaleWord = ".scale";
inline constexpr const char* imageTurnWord = ".rotation";
inline constexpr const char* imageOffsetWord = ".offset";

} // namespace patina
