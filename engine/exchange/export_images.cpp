// SPDX-License-Identifier: GPL-3.0-or-later
#include "exchange/export_images.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>

#include <fmt/format.h>

#include "assets/asset_client.h"
#include "core/color.h"
#include "core/ordinary_file.h"

namespace patina {

namespace {

/// Reads numbers of a picture's texels.
float numberAt(const TexturePicture& picture, std::size_t texel, TextureChannel channel) {
    const std::size_t size = texelBytes(picture.format);
    const std::byte* at = picture.bytes.data() + texel * size;
    const bool isFloat =
        picture.format == TexelFormat::Grey32 || picture.format == TexelFormat::Color32;
    const bool isGrey =
        picture.format == TexelFormat::Grey8 || picture.format == TexelFormat::Grey32;
    const auto part = [&](int index) {
        if (!isFloat) {
            return float(std::to_integer<int>(at[index])) / 255.0f;
        }
        float number = 0.0f;
        std::memcpy(&number, at + std::size_t(index) * sizeof number, sizeof number);
        return number;
    };
    const int alpha = 3;
    const bool isMissingAlpha = channel == TextureChannel::Alpha && !picture.hasAlpha;
    if (isGrey) {
        return part(0);
    }
    if (isMissingAlpha || channel == TextureChannel::Color) {
        return 0.2126f * part(0) + 0.7152f * part(1) + 0.0722f * part(2);
    }
    return part(channel == TextureChannel::Green  ? 1
                : channel == TextureChannel::Blue ? 2
                : channel == TextureChannel::Red  ? 0
                                                  : alpha);
}

/// Returns the image, decoded as it is encoded for a file: its codes are the numbers themselves.
Image roughnessImage(const TexturePicture& picture, TextureChannel channel, bool isOfRoots) {
    const glm::ivec2 size = picture.levels.front().size;
    Image image{size.x, size.y, 3, {}};
    image.pixels.reserve(std::size_t(size.x) * std::size_t(size.y) * 3);
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
            const std::size_t from = std::size_t(size.y - 1 - y) * std::size_t(size.x);
            const float number =
                std::clamp(numberAt(picture, from + std::size_t(x), channel), 0.0f, 1.0f);
            const float root = isOfRoots ? number : std::sqrt(number);
            image.pixels.insert(image.pixels.end(), {1.0f, float(srgbDecoded(root)), 1.0f});
        }
    }
    return image;
}

} // namespace

std::string endingOf(const std::filesystem::path& file) {
    std::string ending = file.extension().string();
    std::ranges::transform(ending, ending.begin(),
                           [](unsigned char letter) { return std::tolower(letter); });
    return ending;
}

Result<std::string> ExportImages::add(const std::string& file,
                                      const std::vector<std::string_view>& endings) {
    if (const auto known = paths_.find(file); known != paths_.end()) {
        return known->second;
    }
    const std::filesystem::path from(file);
    if (!endings.empty() && std::ranges::find(endings, endingOf(from)) == endings.end()) {
        return failure(fmt::format("the format has no {} images", endingOf(from)));
    }
    auto bytes = readFile(from, maxAssetBytes);
    if (!bytes) {
        return tl::unexpected(bytes.error());
    }
    return paths_[file] = take(from.stem().string(), endingOf(from), std::move(*bytes));
}

std::string ExportImages::take(const std::string& name, const std::string& ending,
                               std::string bytes) {
    std::string stem = name;
    std::ranges::replace_if(
        stem, [](unsigned char c) { return c < 128 && std::isalnum(c) == 0 && c != '-'; }, '_');
    std::string path = fmt::format("{}/{}{}", folder_, stem, ending);
    for (int number = 2; places_.contains(path); ++number) {
        path = fmt::format("{}/{}-{}{}", folder_, stem, number, ending);
    }
    places_[path] = files_.size();
    files_.push_back({path, std::move(bytes)});
    return path;
}

Result<std::string> ExportImages::addRoughness(const TextureUse& use, TextureChannel channel) {
    const bool isOfRoots = use.colorSpace == TextureColorSpace::Roots;
    const std::string key =
        fmt::format("{}\n{} {}", use.file, int(channel), static_cast<int>(use.colorSpace));
    if (const auto known = made_.find(key); known != made_.end()) {
        return known->second;
    }
    AssetClient client;
    const auto texture = client.loadTexture(use.file, use.colorSpace == TextureColorSpace::Srgb
                                                          ? TextureDecoding::Srgb
                                                          : TextureDecoding::Linear);
    if (!texture) {
        return tl::unexpected(texture.error());
    }
    auto bytes = client.encodeImage(".png", roughnessImage(**texture, channel, isOfRoots));
    if (!bytes) {
        return tl::unexpected(bytes.error());
    }
    const std::string stem = std::filesystem::path(use.file).stem().string();
    return made_[key] = take(stem + "-roughness", ".png", std::move(*bytes));
}

} // namespace patina
