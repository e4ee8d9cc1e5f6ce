// SPDX-License-Identifier: GPL-3.0-or-later
#include "exchange/image_settings.h"

#include <fmt/format.h>

#include "core/number_text.h"
#include "material/texture_place.h"

namespace patina {

std::string fileNameOf(const std::string& path) {
    return path.substr(path.find_last_of('/') + 1);
}

std::string imageTitle(const TextureUse& use) {
    return "Image " + fileNameOf(use.file);
}

bool isUnplaced(const TextureUse& use) {
    return texturePlace(use) == TexturePlace();
}

bool liesAs(const TextureUse& use, const TextureUse& other) {
    return texturePlace(use) == texturePlace(other) && use.wrap == other.wrap &&
           use.filter == other.filter;
}

bool isAdded(const TextureUse& use) {
    return use.mode == TextureMode::Add;
}

std::string lostSettings(const TextureUse& use) {
    std::string lost;
    const auto lose = [&lost](const std::string& what) {
        lost += (lost.empty() ? "" : ", ") + what;
    };
    if (use.strength != 1.0) {
        lose("strength " + shortestFloatText(use.strength));
    }
    if (use.channel != TextureChannel::Auto && use.channel != TextureChannel::Color) {
        lose("its one channel");
    }
    if (use.colorSpace == TextureColorSpace::Linear) {
        lose("that it is linear");
    }
    if (use.colorSpace == TextureColorSpace::Roots) {
        lose("that its numbers are roots");
    }
    return lost;
}

glm::dvec3 imageFactor(const ExportedLook& look, const std::string& word) {
    const TextureUse* image = look.image(word);
    return image != nullptr && image->mode == TextureMode::Replace ? glm::dvec3(1.0)
                                                                   : look.value(word);
}

} // namespace patina
