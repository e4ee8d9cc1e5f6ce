// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/gpu/texture_source.h"

#include "shading/effects/textures.h"

namespace patina {

TextureDecoding decodingOf(const TextureUse& use, const BoundTexture& image) {
    switch (use.colorSpace) {
    case TextureColorSpace::Srgb:
        return TextureDecoding::Srgb;
    case TextureColorSpace::Linear:
        return TextureDecoding::Linear;
    default:
        return isColorUse(image.role, image.channel) ? TextureDecoding::Color
                                                       : TextureDecoding::Linear;
    }
}

} // namespace patina
