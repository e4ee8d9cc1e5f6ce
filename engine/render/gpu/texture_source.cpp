// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/gpu/texture_source.h"

#include "catalog/combing_role.h"
#include "shading/effects/textures.h"

namespace patina {
namespace {

/// Tells whether the image's colours are numbers along the surface.
bool isAlongSurface(const BoundTexture& image) {
    return image.parameter != nullptr && image.parameter->role == roles::combing;
}

} // namespace

TextureDecoding decodingOf(const TextureUse& use, const BoundTexture& image) {
    switch (use.colorSpace) {
    case TextureColorSpace::Srgb:
        return TextureDecoding::Srgb;
    case TextureColorSpace::Linear:
    case TextureColorSpace::Roots: // which the program squares
        return TextureDecoding::Linear;
    default:
        return isColorUse(image.role, image.channel) && !isAlongSurface(image)
                   ? TextureDecoding::Color
                   : TextureDecoding::Linear;
    }
}

} // namespace patina
