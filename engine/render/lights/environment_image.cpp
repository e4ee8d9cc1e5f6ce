// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/lights/environment_image.h"

#include <algorithm>

#include <glm/common.hpp>
#include <glm/gtc/packing.hpp>
#include <glm/vec3.hpp>

namespace patina {
namespace {

constexpr int widestWhole = 4096;
constexpr int widestSmall = 512;

using Colors = std::vector<glm::vec3>;

float light(float channel) {
    return channel > 0.0f ? std::min(channel, 65504.0f) : 0.0f;
}

Colors colorsOf(const Image& image) {
    const std::size_t count = std::size_t(image.width) * std::size_t(image.height);
    const auto channels = std::size_t(image.channels);
    Colors colors(count);
    for (std::size_t i = 0; i < count; ++i) {
        const float* texel = &image.pixels[i * channels];
        const bool grey = channels < 3;
        colors[i] = {light(texel[0]), light(texel[grey ? 0 : 1]), light(texel[grey ? 0 : 2])};
    }
    return colors;
}

/// Returns where part `index` of `parts` equal parts of `length` begins.
int borderAt(int index, int parts, int length) {
    return static_cast<int>(std::int64_t(index) * length / parts);
}

glm::vec3 meanOf(const Colors& colors, int width, glm::ivec2 from, glm::ivec2 to) {
    glm::dvec3 sum(0.0);
    for (int y = from.y; y < to.y; ++y) {
        for (int x = from.x; x < to.x; ++x) {
            sum += glm::dvec3(colors[std::size_t(y) * std::size_t(width) + std::size_t(x)]);
        }
    }
    return glm::vec3(sum / double((to.x - from.x) * (to.y - from.y)));
}

Colors reduced(const Colors& colors, glm::ivec2 size, glm::ivec2 wanted) {
    if (size == wanted) {
        return colors;
    }
    Colors out;
    out.reserve(std::size_t(wanted.x) * std::size_t(wanted.y));
    for (int y = 0; y < wanted.y; ++y) {
        for (int x = 0; x < wanted.x; ++x) {
            out.push_back(meanOf(
                colors, size.x, {borderAt(x, wanted.x, size.x), borderAt(y, wanted.y, size.y)},
                {borderAt(x + 1, wanted.x, size.x), borderAt(y + 1, wanted.y, size.y)}));
        }
    }
    return out;
}

EnvironmentTexels texelsOf(const Colors& colors, glm::ivec2 size) {
    EnvironmentTexels texels{size, {}};
    texels.halves.reserve(colors.size() * 4);
    for (const glm::vec3& color : colors) {
        for (const float channel : {color.r, color.g, color.b, 1.0f}) {
            texels.halves.push_back(glm::packHalf1x16(channel));
        }
    }
    return texels;
}

/// Limits the width to `widest` and the height to half of `widest`; both are at least 1.
glm::ivec2 limited(glm::ivec2 size, int widest) {
    return glm::max(glm::min(size, glm::ivec2(widest, widest / 2)), glm::ivec2(1));
}

} // namespace

std::shared_ptr<const EnvironmentImage> EnvironmentImage::from(const Image& panorama) {
    const glm::ivec2 size(panorama.width, panorama.height);
    const std::size_t count = std::size_t(size.x) * std::size_t(size.y);
    auto image = std::make_shared<EnvironmentImage>();
    if (size.x < 1 || size.y < 1 || panorama.channels < 1 ||
        panorama.pixels.size() != count * std::size_t(panorama.channels)) {
        image->whole = image->small = texelsOf({glm::vec3(0.0f)}, glm::ivec2(1));
        return image;
    }
    const glm::ivec2 whole = limited(size, widestWhole);
    const glm::ivec2 small = limited(size, widestSmall);
    const Colors colors = reduced(colorsOf(panorama), size, whole);
    image->whole = texelsOf(colors, whole);
    image->small = texelsOf(reduced(colors, whole, small), small);
    return image;
}

std::shared_ptr<const EnvironmentImage> EnvironmentImage::missing() {
    constexpr glm::ivec2 size(128, 64);
    constexpr int texelsPerField = 8;
    Image checker{size.x, size.y, 3, {}};
    for (int i = 0; i < size.x * size.y; ++i) {
        const glm::ivec2 field = glm::ivec2(i % size.x, i / size.x) / texelsPerField;
        for (const float light : {1.0f, 0.0f, 1.0f}) {
            checker.pixels.push_back((field.x + field.y) % 2 == 0 ? light : 0.1f);
        }
    }
    auto placeholder = std::make_shared<EnvironmentImage>(*from(checker));
    placeholder->isMissing = true;
    return placeholder;
}

} // namespace patina
