// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec2.hpp>

namespace patina {

/// Tells how a texel lies in memory. Grey stands for all three colours; a texel without alpha is
/// opaque.
enum class TexelFormat {
    Grey8,
    Color8, ///< four bytes
    Srgb8,  ///< four bytes, the colours encoded in sRGB
    Grey32, ///< a float
    Color32 ///< four floats
};

std::size_t texelBytes(TexelFormat format);

/// Holds an image as the GPU takes it, with all its mipmap levels. Rows go up from the bottom, as v
/// does.
struct TexturePicture {
    struct Level {
        glm::ivec2 size{0};
        std::size_t offset = 0; ///< bytes from the start of `bytes`
    };

    TexelFormat format = TexelFormat::Color8;
    bool hasAlpha = false;     ///< the file has an alpha that is not 1 everywhere
    std::vector<Level> levels; ///< the first is the image itself, the last is one texel
    std::vector<std::byte> bytes;
};

} // namespace patina
