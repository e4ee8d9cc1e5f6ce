// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/image_block.h"

#include <cstdint>
#include <cstring>

namespace patina {
namespace {

constexpr std::uint32_t imageMagic = 0x474d4950; // "PIMG"
constexpr std::uint32_t imageVersion = 1;
constexpr std::size_t maxPixelBytes = std::size_t(1) << 30;

struct ImageHeader {
    std::uint32_t magic = imageMagic;
    std::uint32_t version = imageVersion;
    std::int32_t width = 0;
    std::int32_t height = 0;
    std::int32_t channels = 0;
    std::int32_t bits = 0;
    std::uint32_t reserved[2] = {};
};
static_assert(sizeof(ImageHeader) == 32);

bool isChannelCount(int channels) { return channels == 1 || channels == 3 || channels == 4; }

} // namespace

std::size_t ImageBlock::sizeFor(int width, int height, int channels) {
    if (width <= 0 || height <= 0 || !isChannelCount(channels)) {
        return 0;
    }
    const std::size_t pixelBytes = std::size_t(channels) * sizeof(float);
    if (std::size_t(width) > maxPixelBytes / pixelBytes / std::size_t(height)) {
        return 0;
    }
    return sizeof(ImageHeader) + std::size_t(width) * std::size_t(height) * pixelBytes;
}

void ImageBlock::write(std::span<std::byte> block, const Image& image, int bits) {
    ImageHeader header;
    header.bits = bits;
    header.width = image.width;
    header.height = image.height;
    header.channels = image.channels;
    std::memcpy(block.data(), &header, sizeof header);
    std::memcpy(block.data() + sizeof header, image.pixels.data(),
                image.pixels.size() * sizeof(float));
}

Result<Image> ImageBlock::checked(std::span<const std::byte> block) {
    ImageHeader header;
    if (block.size() < sizeof header) {
        return failure("the image block is shorter than its header");
    }
    std::memcpy(&header, block.data(), sizeof header);
    if (header.magic != imageMagic || header.version != imageVersion) {
        return failure("the image block does not start as one");
    }
    if (block.size() != sizeFor(header.width, header.height, header.channels)) {
        return failure("the image block does not have the size it claims");
    }
    Image image{header.width, header.height, header.channels, {}};
    image.pixels.resize((block.size() - sizeof header) / sizeof(float));
    std::memcpy(image.pixels.data(), block.data() + sizeof header, block.size() - sizeof header);
    return image;
}

int ImageBlock::bits(std::span<const std::byte> block) {
    ImageHeader header;
    std::memcpy(&header, block.data(), sizeof header);
    return header.bits;
}

} // namespace patina
