// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/gpu/capture_image.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <epoxy/gl.h>

#include "gl/framebuffer.h"

namespace patina {
namespace {

constexpr int channels = 4;

Image imageOf(glm::ivec2 size) {
    const std::size_t count = std::size_t(size.x) * std::size_t(size.y) * channels;
    return {size.x, size.y, channels, std::vector<float>(count)};
}

/// Reverses the order of rows, since GL counts them from the bottom.
void flipRows(Image& image) {
    const std::size_t row = std::size_t(image.width) * channels;
    for (int top = 0, bottom = image.height - 1; top < bottom; ++top, --bottom) {
        float* first = image.pixels.data() + std::size_t(top) * row;
        std::swap_ranges(first, first + row, image.pixels.data() + std::size_t(bottom) * row);
    }
}

} // namespace

Image readLinear(unsigned framebuffer, glm::ivec2 size, double exposure) {
    Image image = imageOf(size);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, size.x, size.y, GL_RGBA, GL_FLOAT, image.pixels.data());
    flipRows(image);
    const auto factor = static_cast<float>(std::exp2(std::clamp(exposure, -40.0, 40.0)));
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        image.pixels[i] *= i % channels == 3 ? 1.0f : factor;
    }
    return image;
}

Result<Image> readDisplay(glm::ivec2 size, const std::function<void(unsigned)>& show) {
    const gl::Texture shown = gl::Texture::create(size, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE);
    gl::Framebuffer framebuffer = gl::Framebuffer::create();
    framebuffer.attachColor(shown);
    if (auto drawable = framebuffer.check(); !drawable) {
        return tl::unexpected(drawable.error());
    }
    show(framebuffer.name());
    Image image = imageOf(size);
    std::vector<std::uint8_t> bytes(image.pixels.size());
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer.name());
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, size.x, size.y, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
    std::transform(bytes.begin(), bytes.end(), image.pixels.begin(),
                   [](std::uint8_t byte) { return static_cast<float>(byte) / 255.0f; });
    flipRows(image);
    return image;
}

} // namespace patina
