// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/gpu/texture_source.h"

#include "shading/effects/effect_set.h"
#include "shading/effects/texture_choice.h"

namespace patina {

TextureDecoding decodingOf(const TextureUse& use, const TextureEffect& effect) {
    switch (use.colorSpace) {
    case TextureColorSpace::Srgb:
        return TextureDecoding::Srgb;
    case TextureColorSpace::Linear:
        return TextureDecoding::Linear;
    default:
        return isColorUse(effect.role, effect.channel) ? TextureDecoding::Color
                                                       : TextureDecoding::Linear;
    }
}

} // namespace patina
