// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/gpu/gpu_texture.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <epoxy/gl.h>

#include "core/srgb_table.h"
#include "gl/driver.h"

namespace patina {
namespace {

/// Is the size, in bytes, up to which a level is uploaded at once.
constexpr std::size_t smallBytes = std::size_t(1) << 16;

struct GlFormat {
    GLint internal;
    GLenum format;
    GLenum type;
};

/// Returns true for sRGB on a software driver: llvmpipe decodes it by a polynomial with an error of
/// 1e-3, where other drivers are exact.
bool decodesBadly(TexelFormat format) {
    return format == TexelFormat::Srgb8 && gl::isSoftware();
}

GlFormat formatOf(TexelFormat format, bool decodes) {
    if (decodes) {
        return {GL_RGBA16, GL_RGBA, GL_UNSIGNED_SHORT};
    }
    switch (format) {
    case TexelFormat::Grey8:
        return {GL_R8, GL_RED, GL_UNSIGNED_BYTE};
    case TexelFormat::Srgb8:
        return {GL_SRGB8_ALPHA8, GL_RGBA, GL_UNSIGNED_BYTE};
    case TexelFormat::Grey32:
        return {GL_R32F, GL_RED, GL_FLOAT};
    case TexelFormat::Color32:
        return {GL_RGBA32F, GL_RGBA, GL_FLOAT};
    default:
        return {GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE};
    }
}

/// Returns linear RGBA of 16 bits for sRGB colours with alpha of 8 bits.
std::vector<std::uint16_t> decoded(std::span<const std::byte> codes) {
    static const SrgbTable table;
    const auto whole = [](float x) { return static_cast<std::uint16_t>(x * 65535.0f + 0.5f); };
    std::vector<std::uint16_t> light;
    light.reserve(codes.size());
    for (std::size_t i = 0; i < codes.size(); ++i) {
        const auto code = std::to_integer<std::uint8_t>(codes[i]);
        light.push_back(i % 4 == 3 ? static_cast<std::uint16_t>(257 * code)
                                   : whole(table.decoded(code)));
    }
    return light;
}

bool isGrey(TexelFormat format) {
    return format == TexelFormat::Grey8 || format == TexelFormat::Grey32;
}

std::size_t rowBytes(const TexturePicture& picture, std::size_t level) {
    return std::size_t(picture.levels[level].size.x) * texelBytes(picture.format);
}

} // namespace

GpuTexture::GpuTexture(const TexturePicture& picture, bool isOpaque)
    : decodes_(decodesBadly(picture.format)), level_(picture.levels.size()) {
    GLuint name = 0;
    glGenTextures(1, &name);
    name_ = gl::Name<gl::deleteTexture>(name);
    bind();
    GLint maxSide = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &maxSide);
    const auto isTooLarge = [maxSide](glm::ivec2 size) {
        return std::max(size.x, size.y) > maxSide;
    };
    while (first_ + 1 < picture.levels.size() && isTooLarge(picture.levels[first_].size)) {
        ++first_;
    }
    const GlFormat gl = formatOf(picture.format, decodes_);
    for (std::size_t level = first_; level < picture.levels.size(); ++level) {
        const glm::ivec2 size = picture.levels[level].size;
        glTexImage2D(GL_TEXTURE_2D, static_cast<GLint>(level - first_), gl.internal, size.x, size.y,
                     0, gl.format, gl.type, nullptr);
    }
    const auto last = static_cast<GLint>(picture.levels.size() - 1 - first_);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, last);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, last);
    if (isGrey(picture.format)) {
        constexpr std::array<GLint, 4> grey{GL_RED, GL_RED, GL_RED, GL_RED};
        glTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_RGBA, grey.data());
    }
    if (isOpaque) {
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_A, GL_ONE);
    }
}

void GpuTexture::bind() const {
    glBindTexture(GL_TEXTURE_2D, name_.get());
}

std::size_t GpuTexture::upload(const TexturePicture& picture, std::size_t bytes) {
    bind();
    std::size_t taken = 0;
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    while (level_ > first_) {
        const std::size_t next = level_ - 1;
        const std::size_t row = rowBytes(picture, next);
        const int left = picture.levels[next].size.y - row_;
        const bool isSmall = row * std::size_t(picture.levels[next].size.y) <= smallBytes;
        if (!isSmall && taken >= bytes) {
            break;
        }
        const std::size_t fitting =
            std::max<std::size_t>((bytes - std::min(bytes, taken)) / row, 1);
        const int rows = isSmall ? left : static_cast<int>(std::min(fitting, std::size_t(left)));
        takeRows(picture, next, rows);
        taken += row * std::size_t(rows);
    }
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    return taken;
}

void GpuTexture::takeRows(const TexturePicture& picture, std::size_t level, int rows) {
    sendRows(picture, level, rows);
    row_ += rows;
    if (row_ == picture.levels[level].size.y) {
        row_ = 0;
        level_ = level;
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, static_cast<GLint>(level - first_));
    }
}

void GpuTexture::sendRows(const TexturePicture& picture, std::size_t level, int rows) const {
    const TexturePicture::Level& from = picture.levels[level];
    const std::size_t row = rowBytes(picture, level);
    const std::span<const std::byte> bytes =
        std::span(picture.bytes)
            .subspan(from.offset + std::size_t(row_) * row, std::size_t(rows) * row);
    const GlFormat gl = formatOf(picture.format, decodes_);
    const std::vector<std::uint16_t> light =
        decodes_ ? decoded(bytes) : std::vector<std::uint16_t>();
    const void* const texels = decodes_ ? static_cast<const void*>(light.data()) : bytes.data();
    glTexSubImage2D(GL_TEXTURE_2D, static_cast<GLint>(level - first_), 0, row_, from.size.x, rows,
                    gl.format, gl.type, texels);
}

} // namespace patina
