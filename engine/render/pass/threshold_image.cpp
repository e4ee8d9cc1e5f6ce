// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/pass/threshold_image.h"

#include <algorithm>
#include <cstring>
#include <numeric>

#include <epoxy/gl.h>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace patina {
namespace {

/// Sorting more takes longer than a frame may.
constexpr int maxSide = 512;

const TexturePicture::Level& levelFor(const TexturePicture& picture) {
    const auto fits = std::ranges::find_if(picture.levels, [](const TexturePicture::Level& level) {
        return std::max(level.size.x, level.size.y) <= maxSide;
    });
    return fits == picture.levels.end() ? picture.levels.back() : *fits;
}

template <class Number>
Number numberAt(const std::byte* texel, std::size_t index) {
    Number number{};
    std::memcpy(&number, texel + index * sizeof(Number), sizeof(Number));
    return number;
}

/// Returns the luminance of a texel; Rec. 709's weights.
float brightness(TexelFormat format, const std::byte* texel) {
    const glm::vec3 weights(0.2126f, 0.7152f, 0.0722f);
    switch (format) {
    case TexelFormat::Grey8:
        return numberAt<unsigned char>(texel, 0);
    case TexelFormat::Grey32:
        return numberAt<float>(texel, 0);
    case TexelFormat::Color32:
        return glm::dot(weights, glm::vec3(numberAt<float>(texel, 0), numberAt<float>(texel, 1),
                                           numberAt<float>(texel, 2)));
    default:
        return glm::dot(weights, glm::vec3(numberAt<unsigned char>(texel, 0),
                                           numberAt<unsigned char>(texel, 1),
                                           numberAt<unsigned char>(texel, 2)));
    }
}

} // namespace

Thresholds thresholdsOf(const TexturePicture& picture) {
    if (picture.levels.empty()) {
        return {glm::ivec2(1), {0.5f}};
    }
    const TexturePicture::Level& level = levelFor(picture);
    const auto count = static_cast<std::size_t>(level.size.x) * std::size_t(level.size.y);
    const std::size_t step = texelBytes(picture.format);
    std::vector<float> bright(count);
    for (std::size_t i = 0; i < count; ++i) {
        bright[i] = brightness(picture.format, picture.bytes.data() + level.offset + i * step);
    }
    // Knuth's multiplicative hash scatters what is equal.
    const auto scattered = [](std::uint32_t i) { return i * 2654435769U; };
    std::vector<std::uint32_t> order(count);
    std::iota(order.begin(), order.end(), 0U);
    std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) {
        return bright[a] != bright[b] ? bright[a] < bright[b] : scattered(a) < scattered(b);
    });
    Thresholds thresholds{level.size, std::vector<float>(count)};
    for (std::size_t i = 0; i < count; ++i) {
        thresholds.values[order[i]] = (float(i) + 0.5f) / float(count);
    }
    return thresholds;
}

bool ThresholdImage::take(const std::string& file, const GpuTextureStore& images) {
    TextureUse use;
    use.file = file;
    const TextureLookup found =
        file.empty() ? TextureLookup{nullptr, true} : images.look(use, TextureDecoding::Linear);
    if (found.picture != shown_ || texture_.size().x == 0) {
        shown_ = found.picture;
        show(shown_ ? thresholdsOf(*shown_) : Thresholds{glm::ivec2(1), {0.5f}});
    }
    return found.picture != nullptr || found.isMissing;
}

void ThresholdImage::show(const Thresholds& thresholds) {
    glActiveTexture(GL_TEXTURE0);
    texture_ =
        gl::Texture::create(thresholds.size, GL_R32F, GL_RED, GL_FLOAT, thresholds.values.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_REPEAT);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
}

void ThresholdImage::bind(unsigned unit) const {
    if (texture_.name() == 0) {
        return;
    }
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(GL_TEXTURE_2D, texture_.name());
}

} // namespace patina
