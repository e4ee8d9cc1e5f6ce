// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace patina::binding {

/// Binding points of the uniform blocks.
inline constexpr unsigned view = 0;
inline constexpr unsigned scene = 1;
inline constexpr unsigned object = 2;

/// Texture units of a material's images, one for each.
inline constexpr unsigned firstTexture = 8;

/// The texture unit of the shadows' depth maps.
inline constexpr unsigned shadowMaps = 7;

} // namespace patina::binding
