// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/gpu/texture_loader.h"

namespace patina {

TextureLookup TextureLoader::find(const TextureUse& use, TextureDecoding decoding) {
    if (use.outside) {
        return {nullptr, true};
    }
    const auto [place, isNew] = found_.try_emplace({use.file, decoding});
    if (isNew) {
        auto picture = client_.loadTexture(use.file, decoding);
        if (picture) {
            place->second.picture = std::move(*picture);
        } else {
            place->second.isMissing = true;
            problems_.push_back(picture.error());
        }
    }
    return place->second;
}

TextureSource TextureLoader::source() {
    return [this](const TextureUse& use, TextureDecoding decoding) { return find(use, decoding); };
}

} // namespace patina
