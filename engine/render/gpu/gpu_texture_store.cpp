// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/gpu/gpu_texture_store.h"

#include <algorithm>
#include <array>

#include <epoxy/gl.h>

#include "render/gpu/binding.h"

namespace patina {
namespace {

constexpr std::uint64_t texturesKept = 120;

/// RGBA, 0 .. 1
using Texel = std::array<float, 4>;

/// Makes a checker of eight by eight fields, which nobody takes for a real image.
std::shared_ptr<const TexturePicture> checker(const Texel& light, const Texel& dark) {
    constexpr int fields = 8;
    constexpr int texelsPerField = 8;
    constexpr int size = fields * texelsPerField;
    FileImage image{{size, size, 4, {}}, 8};
    for (int i = 0; i < size * size; ++i) {
        const bool isLight = (i % size / texelsPerField + i / size / texelsPerField) % 2 == 0;
        const Texel& field = isLight ? light : dark;
        image.image.pixels.insert(image.image.pixels.end(), field.begin(), field.end());
    }
    return std::make_shared<const TexturePicture>(madeTexture(image, TextureDecoding::Linear));
}

/// Returns the placeholder of an image that cannot be read: two colours; normals that lean to the
/// left and to the right; or heights or opacities of 0 and 1.
const std::shared_ptr<const TexturePicture>& placeholder(TextureRole role) {
    static const auto colors = checker({1.0f, 0.0f, 1.0f, 1.0f}, {0.1f, 0.1f, 0.1f, 1.0f});
    static const auto slopes = checker({0.75f, 0.5f, 0.9f, 1.0f}, {0.25f, 0.5f, 0.9f, 1.0f});
    static const auto steps = checker({1.0f, 1.0f, 1.0f, 1.0f}, {0.0f, 0.0f, 0.0f, 0.0f});
    switch (role) {
    case TextureRole::Normal:
        return slopes;
    case TextureRole::Height:
    case TextureRole::Opacity:
        return steps;
    default:
        return colors;
    }
}

/// Returns true where a use reads the alpha of an image that has none: it must be 1 there. For
/// other uses the alpha of such an image holds its grey.
bool showsOpaque(const TexturePicture& picture, const TextureUse& use) {
    return !picture.hasAlpha && use.channel == TextureChannel::Alpha;
}

GLenum wrapOf(TextureWrap wrap) {
    switch (wrap) {
    case TextureWrap::Clamp:
        return GL_CLAMP_TO_EDGE;
    case TextureWrap::Mirror:
        return GL_MIRRORED_REPEAT;
    default:
        return GL_REPEAT;
    }
}

} // namespace

void GpuTextureStore::bind(std::span<glm::vec4> data, const Pipeline& pipeline,
                           const Material& material, TextureBudget& budget, ShownTextures& shown) {
    const auto& images = pipeline.effects.textures;
    for (std::size_t i = 0; i < images.size(); ++i) {
        if (images[i].isOfVertices) {
            continue;
        }
        const unsigned unit = binding::firstTexture + static_cast<unsigned>(i);
        glActiveTexture(GL_TEXTURE0 + unit);
        bindOne(images[i], material, data[std::size_t(pipeline.object.texture(i))], budget, shown);
        if (const TextureUse* use = images[i].in(material)) {
            sampler(*use).bind(unit);
        }
    }
    glActiveTexture(GL_TEXTURE0);
}

std::uint64_t GpuTextureStore::stateOf(const BoundTexture& image, const Material& material) const {
    const TextureUse* use = image.in(material);
    if (!source_ || use == nullptr) {
        return 0;
    }
    const TextureLookup found = source_(*use, decodingOf(*use, image));
    const bool isOpaque = found.picture && showsOpaque(*found.picture, *use);
    const auto entry = entries_.find({found.picture.get(), isOpaque});
    const bool isComplete = entry != entries_.end() && entry->second.texture->isComplete();
    // Addresses are even.
    return std::uint64_t(reinterpret_cast<std::uintptr_t>(found.picture.get())) +
           (isComplete ? 1 : 0);
}

/// Binds one image or its placeholder. A placeholder of a relief keeps the relief's strength; any
/// other has full weight, so that it is seen.
void GpuTextureStore::bindOne(const BoundTexture& image, const Material& material, glm::vec4& data,
                              TextureBudget& budget, ShownTextures& shown) {
    const TextureUse* use = image.in(material);
    TextureLookup found;
    if (source_ && use != nullptr) {
        found = source_(*use, decodingOf(*use, image));
    }
    if (found.picture) {
        shown.push_back(show(found.picture, showsOpaque(*found.picture, *use), budget));
        return;
    }
    shown.push_back(show(placeholder(image.role), false, budget));
    const bool isRelief = image.role == TextureRole::Normal || image.role == TextureRole::Height;
    if (!found.isMissing) {
        data.w = 0.0f;
    } else if (!isRelief) {
        data.w = 1.0f;
    }
}

std::shared_ptr<const GpuTexture>
GpuTextureStore::show(const std::shared_ptr<const TexturePicture>& picture, bool isOpaque,
                      TextureBudget& budget) {
    const EntryKey key{picture.get(), isOpaque};
    auto entry = entries_.find(key);
    if (entry == entries_.end()) {
        entry =
            entries_.emplace(key, Entry{picture, std::make_shared<GpuTexture>(*picture, isOpaque)})
                .first;
    }
    entry->second.lastFrame = frame_;
    GpuTexture& texture = *entry->second.texture;
    if (texture.isComplete()) {
        texture.bind();
    } else {
        budget.bytesLeft -= std::min(budget.bytesLeft, texture.upload(*picture, budget.bytesLeft));
        budget.isWaiting = budget.isWaiting || !texture.isComplete();
    }
    return entry->second.texture;
}

const gl::Sampler& GpuTextureStore::sampler(const TextureUse& use) {
    const bool isSmooth = use.filter == TextureFilter::Smooth;
    auto& held = samplers_[std::size_t(use.wrap) * 2 + (isSmooth ? 1 : 0)];
    if (!held) {
        held = gl::Sampler::create(wrapOf(use.wrap), isSmooth);
    }
    return *held;
}

void GpuTextureStore::endFrame() {
    std::erase_if(entries_, [this](const auto& entry) {
        return frame_ - entry.second.lastFrame > texturesKept &&
               entry.second.texture.use_count() == 1;
    });
    ++frame_;
}

} // namespace patina
