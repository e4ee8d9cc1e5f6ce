// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string_view>

#include "catalog/catalog.h"
#include "material/material.h"
#include "scene/scene.h"

namespace patina {

/// So many images of one material are in its program: texture units are few.
inline constexpr std::size_t maxTextures = 8;

/// What an image of a material changes, or why it changes nothing.
struct TextureTarget {
    TextureRole role = TextureRole::Input;
    std::string_view kind{};              ///< "models" or a part's, for the role Input
    const Parameter* parameter = nullptr; ///< then
    const char* whyNot = nullptr;         ///< a sentence; null: it has its effect
};

/// Allocates nothing. `key` is that of the use in Material::textures.
TextureTarget textureTarget(std::string_view key, const TextureUse& use, const Material& material,
                            const Catalog& catalog);

/// The channel that counts: never Auto. Where that makes alpha of it the grey of an image without
/// alpha counts (see TexturePicture::hasAlpha).
TextureChannel channelOf(const TextureUse& use, const TextureTarget& target);

/// Whether the colours of the file are taken as light: those that Auto takes for encoded.
bool isColorUse(TextureRole role, TextureChannel channel);

/// Whether an image gives the parameter another value than the form's.
bool isTextured(std::string_view parameterId, const Material& material);

/// Whether anything of the material may be there.
bool canBeSeen(const Material& material);

/// Whether a frame has anything of the object.
bool isDrawn(const Object& object);

/// Whether something behind the material may shine through: by its opacity, or by an image of it
/// that does not only cut out, or by its model.
bool isTransparent(const Material& material, const Catalog& catalog);

} // namespace patina
