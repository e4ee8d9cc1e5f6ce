// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>

#include "assets/texture_maker.h"
#include "material/texture_use.h"

namespace patina {

/// Holds an image, or whether it will never come; neither is set while it is being loaded.
struct TextureLookup {
    std::shared_ptr<const TexturePicture> picture;
    bool isMissing = false; ///< is true when it cannot be read: a placeholder is drawn
};

/// Returns the image of a use. While it is being loaded the surface is drawn without it. It is
/// called for each frame and must not allocate for an image that it knows.
using TextureSource = std::function<TextureLookup(const TextureUse&, TextureDecoding)>;

struct BoundTexture;

/// Returns how to decode the file of a use: as its colour space says, else by its role in the
/// program.
TextureDecoding decodingOf(const TextureUse& use, const BoundTexture& image);

} // namespace patina
