// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>

#include "assets/texture_maker.h"
#include "material/texture_use.h"

namespace patina {

/// Holds what there is of an image now.
struct TextureLookup {
    std::shared_ptr<const TexturePicture> picture;
    bool isMissing = false; ///< and will not come: a placeholder is drawn
};

/// Gives the image of a use. While there is none and it is not missing either, the surface is drawn
/// without it. Called for each frame; must not allocate for what is known.
using TextureSource = std::function<TextureLookup(const TextureUse&, TextureDecoding)>;

struct BoundTexture;

/// Returns how the numbers of the use's file are taken, for what it does in a program.
TextureDecoding decodingOf(const TextureUse& use, const BoundTexture& image);

} // namespace patina
