// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include <boost/container/small_vector.hpp>

#include "shading/effects/effect_parts.h"

namespace patina {

/// So many images of one material are in its program: texture units are few.
inline constexpr std::size_t maxTextures = 8;

/// Holds what an image of a material changes, or why it changes nothing.
struct TextureTarget {
    TextureRole role = TextureRole::Input;
    std::string_view kind{};              ///< "models" or a part's, for the role Input
    const Parameter* parameter = nullptr; ///< then
    const char* whyNot = nullptr;         ///< a sentence; null: it has its effect
};

/// Allocates nothing. `key` is that of the use in Material::textures.
TextureTarget textureTarget(std::string_view key, const TextureUse& use, const Material& material,
                            const Catalog& catalog);

/// Returns the channel that counts: never Auto. Where that makes alpha of it the grey of an image
/// without alpha counts (see TexturePicture::hasAlpha).
TextureChannel channelOf(const TextureUse& use, const TextureTarget& target);

/// Tells whether the colours of the file are taken as light: those that Auto takes for encoded.
bool isColorUse(TextureRole role, TextureChannel channel);

/// Tells whether an image gives the parameter another value than the form's.
bool isTextured(std::string_view parameterId, const Material& material);

/// Represents an image that is in a program. Which image, and where it lies on the surface, is
/// data.
struct BoundTexture {
    TextureRole role = TextureRole::Input;
    std::string_view kind{};              ///< role Input: "models" or a part's
    const Parameter* parameter = nullptr; ///< then; it is the catalogue's
    TextureChannel channel = TextureChannel::Color;
    TextureMode mode = TextureMode::Replace;
    bool cutOut = false;
    bool isOfVertices = false; ///< it is the mesh's colours and has no sampler
    bool isOfRoots = false;    ///< its numbers are square roots

    /// Its key in Material::textures, and whether a key is that.
    std::string key() const;
    bool hasKey(std::string_view key) const;

    /// Returns what the material says of it; null where it says nothing any more.
    const TextureUse* in(const Material& material) const;

    bool isColor() const;

    friend bool operator==(const BoundTexture&, const BoundTexture&) = default;
};

/// Returns how an image is used that has an effect.
BoundTexture boundTexture(const TextureUse& use, const TextureTarget& target);

/// Holds the material's images, sorted by their keys.
struct TexturesEffect {
    boost::container::small_vector<BoundTexture, maxTextures> textures;

    void choose(const MaterialSubject& subject, const EffectSet& set);
    void addTo(ChoiceHash& hash) const;
    void list(EffectListing& listing, const EffectSet& set) const;
    void listMissing(LeftOutListing& listing, const EffectSet& set) const;
    EffectLine absent(const EffectSet&) const {
        return {"texture", {}, "No image is bound to the material."};
    }
    void place(ObjectLayout& layout, const EffectSet& set) const;
    std::string_view whyPerPixel(const EffectSet& set) const;
    bool readsVertexColors() const;
    static void remove(Scene& scene, const EffectName& effect, const Catalog& catalog);

    friend bool operator==(const TexturesEffect&, const TexturesEffect&) = default;
};

/// Makes levels that read a table exact where an image changes what the table's entries depend on.
void makeTexturedExact(BlockUse& use, const EffectSet& set);

} // namespace patina
