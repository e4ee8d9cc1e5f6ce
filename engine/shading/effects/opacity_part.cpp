// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/opacity_part.h"

#include <algorithm>

namespace patina {

OpacityPart opacityPart(const EffectSet& set, const ObjectLayout& layout) {
    OpacityPart part;
    part.layout.transparency = layout.transparency;
    const auto found = std::ranges::find(set.textures, TextureRole::Opacity, &BoundTexture::role);
    if (found != set.textures.end()) {
        part.image = static_cast<std::size_t>(found - set.textures.begin());
        part.set.opacity = set.opacity;
        part.set.textures = {*found};
        part.layout.firstTexture = layout.texture(*part.image);
        part.layout.vec4s = layout.vec4s;
    }
    return part;
}

} // namespace patina
