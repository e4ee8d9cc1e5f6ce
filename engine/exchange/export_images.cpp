// SPDX-License-Identifier: GPL-3.0-or-later
#include "exchange/export_images.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>
#include <memory>

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

/// Has the numbers of an image that was read; 1 where there is none.
struct ReadNumbers {
    std::shared_ptr<const TexturePicture> picture;
    TextureChannel channel = TextureChannel::Auto;
    bool isOfRoots = false;

    glm::ivec2 size() const { return picture ? picture->levels.front().size : glm::ivec2(1); }

    /// Returns the number at a pixel of an image of another size, whose rows go down.
    float at(int x, int y, glm::ivec2 among) const {
        if (!picture) {
            return 1.0f;
        }
        const glm::ivec2 own = size();
        const std::size_t column = std::size_t(x) * std::size_t(own.x) / std::size_t(among.x);
        const std::size_t row =
            std::size_t(among.y - 1 - y) * std::size_t(own.y) / std::size_t(among.y);
        const std::size_t texel = row * std::size_t(own.x) + column;
        return std::clamp(numberAt(*picture, texel, channel), 0.0f, 1.0f);
    }
};

Result<ReadNumbers> read(AssetClient& client, const ExportImages::Numbers& numbers) {
    const TextureUse& use = numbers.use;
    auto picture = client.loadTexture(use.file, use.colorSpace == TextureColorSpace::Srgb
                                                    ? TextureDecoding::Srgb
                                                    : TextureDecoding::Linear);
    if (!picture) {
        return tl::unexpected(picture.error());
    }
    return ReadNumbers{std::move(*picture), numbers.channel,
                       use.colorSpace == TextureColorSpace::Roots};
}

/// Returns the image, decoded as it is encoded for a file: its codes are the numbers themselves.
Image metallicRoughnessImage(const ReadNumbers& widths, const ReadNumbers& metalness) {
    const glm::ivec2 size = glm::max(widths.size(), metalness.size());
    Image image{size.x, size.y, 3, {}};
    image.pixels.reserve(std::size_t(size.x) * std::size_t(size.y) * 3);
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
            const float width = widths.at(x, y, size);
            const float root = widths.isOfRoots ? width : std::sqrt(width);
            image.pixels.insert(image.pixels.end(), {1.0f, float(srgbDecoded(root)),
                                                     float(srgbDecoded(metalness.at(x, y, size)))});
        }
    }
    return image;
}

/// Tells whether an image is one of glTF already.
bool isGltfs(const std::optional<ExportImages::Numbers>& widths,
             const std::optional<ExportImages::Numbers>& metalness) {
    return widths && metalness && widths->use.file == metalness->use.file &&
           widths->channel == TextureChannel::Green &&
           widths->use.colorSpace == TextureColorSpace::Roots &&
           metalness->channel == TextureChannel::Blue &&
           metalness->use.colorSpace != TextureColorSpace::Srgb;
}

std::string keyOf(const std::optional<ExportImages::Numbers>& numbers) {
    return numbers ? fmt::format("{}\n{} {}", numbers->use.file, int(numbers->channel),
                                 static_cast<int>(numbers->use.colorSpace))
                   : std::string();
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

Result<std::string> ExportImages::addMetallicRoughness(const std::optional<Numbers>& widths,
                                                       const std::optional<Numbers>& metalness) {
    const std::vector<std::string_view> endings{".png", ".jpg", ".jpeg"};
    if (isGltfs(widths, metalness) &&
        std::ranges::find(endings, endingOf(widths->use.file)) != endings.end()) {
        return add(widths->use.file, endings);
    }
    const std::string key = keyOf(widths) + '\n' + keyOf(metalness);
    if (const auto known = made_.find(key); known != made_.end()) {
        return known->second;
    }
    AssetClient client;
    const Result<ReadNumbers> readWidths = widths ? read(client, *widths) : ReadNumbers();
    const Result<ReadNumbers> readMetalness = metalness ? read(client, *metalness) : ReadNumbers();
    if (!readWidths || !readMetalness) {
        return tl::unexpected(readWidths ? readMetalness.error() : readWidths.error());
    }
    auto bytes = client.encodeImage(".png", metallicRoughnessImage(*readWidths, *readMetalness));
    if (!bytes) {
        return tl::unexpected(bytes.error());
    }
    const std::string stem =
        std::filesystem::path((metalness ? metalness : widths)->use.file).stem().string();
    return made_[key] =
               take(stem + (metalness ? "-metal" : "") + "-roughness", ".png", std::move(*bytes));
}

} // namespace patina
