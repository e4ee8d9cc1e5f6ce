// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/texture_maker.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

#include <glm/common.hpp>
#include <glm/vec4.hpp>

#include "core/color.h"
#include "core/srgb_table.h"

namespace patina {
namespace {

constexpr float maxHalf = 65504.0f; ///< is the largest half float; sums of such floats stay finite

const SrgbTable& srgb() {
    static const SrgbTable table;
    return table;
}

float usable(float x) {
    return std::isfinite(x) ? std::clamp(x, -maxHalf, maxHalf) : 0.0f;
}

std::uint8_t code(float x) {
    return static_cast<std::uint8_t>(std::clamp(x, 0.0f, 1.0f) * 255.0f + 0.5f);
}

/// Reads and writes texels of one format as four linear floats.
class Texels {
  public:
    explicit Texels(TexelFormat format) : format_(format), bytes_(texelBytes(format)) {}

    glm::vec4 read(const std::byte* at) const {
        if (format_ == TexelFormat::Grey32 || format_ == TexelFormat::Color32) {
            std::array<float, 4> held{0.0f, 0.0f, 0.0f, 1.0f};
            std::memcpy(held.data(), at, bytes_);
            return format_ == TexelFormat::Color32 ? glm::vec4(held[0], held[1], held[2], held[3])
                                                   : glm::vec4(held[0]);
        }
        const auto part = [at](int i) { return std::to_integer<std::uint8_t>(at[i]); };
        if (format_ == TexelFormat::Grey8) {
            return glm::vec4(static_cast<float>(part(0)) / 255.0f);
        }
        glm::vec4 texel(part(0), part(1), part(2), part(3));
        texel /= 255.0f;
        for (int i = 0; i < 3 && format_ == TexelFormat::Srgb8; ++i) {
            texel[i] = srgb().decoded(part(i));
        }
        return texel;
    }

    void write(std::byte* at, const glm::vec4& texel) const {
        if (format_ == TexelFormat::Grey32 || format_ == TexelFormat::Color32) {
            std::memcpy(at, &texel, bytes_);
            return;
        }
        const std::size_t count = bytes_;
        for (std::size_t i = 0; i < count; ++i) {
            const float value = texel[static_cast<int>(i)];
            const bool encodes = format_ == TexelFormat::Srgb8 && i < 3;
            at[i] = std::byte(encodes ? srgb().encoded(value) : code(value));
        }
    }

    std::size_t size() const { return bytes_; }

  private:
    TexelFormat format_;
    std::size_t bytes_;
};

/// Says which texels of a row or column make one texel of the next smaller level, and their
/// weights.
struct Taps {
    int first = 0;
    int count = 1;
    std::array<float, 3> shares{1.0f, 0.0f, 0.0f};
};

/// Returns the texels that make texel `index` of a level half as long as `length` (rounded down):
/// two texels, or three with weights where `length` is odd.
Taps tapsOf(int index, int length) {
    if (length == 1) {
        return {};
    }
    if (length % 2 == 0) {
        return {2 * index, 2, {0.5f, 0.5f, 0.0f}};
    }
    const int half = length / 2;
    const auto all = static_cast<float>(length);
    return {2 * index,
            3,
            {static_cast<float>(half - index) / all, static_cast<float>(half) / all,
             static_cast<float>(index + 1) / all}};
}

void reduce(TexturePicture& picture, std::size_t level) {
    const TexturePicture::Level& from = picture.levels[level - 1];
    const TexturePicture::Level& to = picture.levels[level];
    const Texels texels(picture.format);
    for (int y = 0; y < to.size.y; ++y) {
        const Taps rows = tapsOf(y, from.size.y);
        for (int x = 0; x < to.size.x; ++x) {
            const Taps columns = tapsOf(x, from.size.x);
            glm::vec4 sum(0.0f);
            for (int j = 0; j < rows.count; ++j) {
                const std::size_t row = std::size_t(rows.first + j) * std::size_t(from.size.x) +
                                        std::size_t(columns.first);
                for (int i = 0; i < columns.count; ++i) {
                    const std::byte* at =
                        picture.bytes.data() + from.offset + (row + std::size_t(i)) * texels.size();
                    sum += rows.shares[std::size_t(j)] * columns.shares[std::size_t(i)] *
                           texels.read(at);
                }
            }
            const std::size_t place = std::size_t(y) * std::size_t(to.size.x) + std::size_t(x);
            texels.write(picture.bytes.data() + to.offset + place * texels.size(), sum);
        }
    }
}

/// Chooses the format of the texels. A grey image that `keepsCodes` needs four channels, because
/// its alpha holds a number other than its colour.
TexelFormat formatFor(const FileImage& source, bool decodes, bool keepsCodes) {
    const bool grey = source.image.channels == 1;
    if (source.bits != 8) {
        return grey && !keepsCodes ? TexelFormat::Grey32 : TexelFormat::Color32;
    }
    return decodes ? TexelFormat::Srgb8 : grey ? TexelFormat::Grey8 : TexelFormat::Color8;
}

glm::vec4 texelOf(const Image& image, std::size_t at) {
    const float* from = &image.pixels[at * std::size_t(image.channels)];
    if (image.channels == 1) {
        return {from[0], from[0], from[0], 1.0f};
    }
    return {from[0], from[1], from[2], image.channels == 4 ? from[3] : 1.0f};
}

bool hasAlpha(const Image& image) {
    for (std::size_t i = 3; image.channels == 4 && i < image.pixels.size(); i += 4) {
        if (usable(image.pixels[i]) < 1.0f) {
            return true;
        }
    }
    return false;
}

glm::vec4 usable(glm::vec4 texel) {
    for (int i = 0; i < 4; ++i) {
        texel[i] = usable(texel[i]);
    }
    return texel;
}

glm::vec4 decoded(glm::vec4 texel, int bits) {
    for (int i = 0; i < 3; ++i) {
        texel[i] = bits == 8 ? srgb().decoded(code(texel[i]))
                             : static_cast<float>(srgbDecoded(double(texel[i])));
    }
    return texel;
}

/// Returns the luminance of Rec. 709; for a grey exactly the number itself.
float greyOf(const glm::vec4& texel) {
    return texel.g + 0.2126f * (texel.r - texel.g) + 0.0722f * (texel.b - texel.g);
}

/// Writes level 0, from the bottom row up. Where the image has no alpha, the alpha of the texel is
/// its grey: that of the file's numbers if `keepsCodes`, else that of the texel itself.
void fill(TexturePicture& picture, const FileImage& source, bool decodes, bool keepsCodes) {
    const Image& image = source.image;
    const Texels texels(picture.format);
    std::byte* to = picture.bytes.data();
    for (int y = image.height - 1; y >= 0; --y) {
        for (int x = 0; x < image.width; ++x) {
            const glm::vec4 numbers =
                usable(texelOf(image, std::size_t(y) * std::size_t(image.width) + std::size_t(x)));
            glm::vec4 texel = decodes ? usable(decoded(numbers, source.bits)) : numbers;
            if (!picture.hasAlpha) {
                texel.a = greyOf(keepsCodes ? numbers : texel);
            }
            texels.write(to, texel);
            to += texels.size();
        }
    }
}

void addLevels(TexturePicture& picture, glm::ivec2 size) {
    std::size_t offset = 0;
    while (true) {
        picture.levels.push_back({size, offset});
        offset += std::size_t(size.x) * std::size_t(size.y) * texelBytes(picture.format);
        if (size == glm::ivec2(1)) {
            break;
        }
        size = glm::max(size / 2, glm::ivec2(1));
    }
    picture.bytes.resize(offset);
}

} // namespace

TexturePicture madeTexture(const FileImage& source, TextureDecoding decoding,
                           const std::function<bool()>& cancelled) {
    const bool decodes = decoding == TextureDecoding::Srgb ||
                         (decoding == TextureDecoding::Color && source.bits != 0);
    const bool keepsCodes = decodes && decoding == TextureDecoding::Color;
    TexturePicture picture;
    picture.format = formatFor(source, decodes, keepsCodes);
    picture.hasAlpha = hasAlpha(source.image);
    addLevels(picture, {source.image.width, source.image.height});
    fill(picture, source, decodes, keepsCodes);
    for (std::size_t level = 1; level < picture.levels.size(); ++level) {
        if (cancelled && cancelled()) {
            picture.levels.resize(level);
            break;
        }
        reduce(picture, level);
    }
    return picture;
}

} // namespace patina
