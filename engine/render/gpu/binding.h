// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace patina::binding {

/// Binding points of the uniform blocks.
inline constexpr unsigned view = 0;
inline constexpr unsigned scene = 1;
inline constexpr unsigned object = 2;
inline constexpr unsigned environment = 3;

/// Texture units, of the 16 that every driver has. Passes that draw no surface use the first ones.
/// Transparent layers: what was drawn of them.
inline constexpr unsigned layerSum = 0;
inline constexpr unsigned layerShare = 1;
inline constexpr unsigned nearerLayer = 2;

/// Refracting surfaces, which are no such layers: the farthest surface of the body, and what was
/// drawn before it.
inline constexpr unsigned refractionBack = 0;
inline constexpr unsigned behindColor = 1;
inline constexpr unsigned behindDepth = 2;

/// Are the tables that a material's blocks read in place of computing.
inline constexpr unsigned blockTables = 3;

/// Is an environment: where it is bright, its picture, and that in small.
inline constexpr unsigned environmentTable = 4;
inline constexpr unsigned environmentImage = 5;
inline constexpr unsigned environmentSmall = 6;

/// In place of the first and the last of these, where a material's light is fitted: its lobes, and
/// the environment in steps of blur.
inline constexpr unsigned lobeTable = environmentTable;
inline constexpr unsigned environmentBlurred = environmentSmall;

/// Has the shadow maps.
inline constexpr unsigned shadowMaps = 7;

/// Begins a material's images, one unit for each.
inline constexpr unsigned firstTexture = 8;

} // namespace patina::binding
