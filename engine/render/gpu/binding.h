// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace patina::binding {

/// These are the binding points of the uniform blocks.
inline constexpr unsigned view = 0;
inline constexpr unsigned scene = 1;
inline constexpr unsigned object = 2;
inline constexpr unsigned environment = 3;

/// These are texture units, of the 16 that every driver has. Passes that draw no surface use the
/// first ones. A blended layer reads here what was drawn of the layers before it.
inline constexpr unsigned layerSum = 0;
inline constexpr unsigned layerShare = 1;
inline constexpr unsigned nearerLayer = 2;

/// A refracting surface, which is never such a layer, reads the farthest surface of its body here,
/// and the colour and depth of what was drawn before it.
inline constexpr unsigned refractionBack = 0;
inline constexpr unsigned behindColor = 1;
inline constexpr unsigned behindDepth = 2;

/// Holds the tables of a material's blocks, which they read instead of computing.
inline constexpr unsigned blockTables = 3;

/// An environment has its sampling table, its picture and its small picture here.
inline constexpr unsigned environmentTable = 4;
inline constexpr unsigned environmentImage = 5;
inline constexpr unsigned environmentSmall = 6;

/// Where a material's light is fitted to lobes, two of these units hold its lobes and the blurred
/// levels of the environment instead.
inline constexpr unsigned lobeTable = environmentTable;
inline constexpr unsigned environmentBlurred = environmentSmall;

/// Holds the shadow maps.
inline constexpr unsigned shadowMaps = 7;

/// Is the first unit for a material's images, which have one unit each.
inline constexpr unsigned firstTexture = 8;

/// Holds the table of a measured file. It lies behind the 16 units that a fragment shader has at
/// least, of 80 in all: a program reads at most 16, wherever they lie.
inline constexpr unsigned measuredTable = 16;

} // namespace patina::binding
