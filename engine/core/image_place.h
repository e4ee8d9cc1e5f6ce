// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace patina {

// These follow the word of an image in MeshMaterial::values and say how it lies, as
// KHR_texture_transform does: coordinates that begin at the top are scaled, turned by radians,
// moved.
inline constexpr const char* imageScaleWord = ".scale";
inline constexpr const char* imageTurnWord = ".rotation";
inline constexpr const char* imageOffsetWord = ".offset";

// These say in the same way whether an image ends at its edge (1) or is mirrored there (2), and
// whether its pixels stay square (1); it goes on and is smooth where nothing is said.
inline constexpr const char* imageWrapWord = ".wrap";
inline constexpr const char* imageNearestWord = ".nearest";

// These say in the same way which channel has the numbers, from red (0) to alpha (3), and that they
// are square roots (1).
inline constexpr const char* imageChannelWord = ".channel";
inline constexpr const char* imageRootWord = ".root";

} // namespace patina
