// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace patina {

/// Names in the extras of a glTF material what Patina keeps there: under `presetKey` the preset,
/// under `writtenKey` the factors that were written with it, in the order of their names, and under
/// `imagesKey` what its images are: their URIs, or contentHash() of those inside the file.
inline constexpr const char* ownExtras = "patina";
inline constexpr const char* presetKey = "preset";
inline constexpr const char* writtenKey = "written";
inline constexpr const char* imagesKey = "images";

/// Stands before the contentHash() of an image inside the file where a preset in it names that.
inline constexpr const char* insidePrefix = "image:";

/// Is the name of an image of roughness whose metalness is 1 everywhere.
inline constexpr const char* roughnessAlone = "roughness alone";

/// Names in a material's extras what a glTF file said beyond what a material has; it has the keys
/// "extensions" and "extras" of the file.
inline constexpr const char* foreignKey = "gltf";

} // namespace patina
