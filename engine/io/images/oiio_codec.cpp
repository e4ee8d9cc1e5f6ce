// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/images/oiio_codec.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <string_view>
#include <utility>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include "core/color.h"
#include "core/ordinary_file.h"

namespace patina {
namespace {

constexpr std::int64_t maxPixels = std::int64_t(1) << 26; // 8192 x 8192, 1 GiB as RGBA floats

Error readError(const std::filesystem::path& file, std::string why) {
    while (!why.empty() && (why.back() == '\n' || why.back() == '.')) {
        why.pop_back();
    }
    return Error{file.string(), 0, 0, why.empty() ? "cannot be read as an image" : why, {}};
}

std::string lowerCase(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::tolower(c); });
    return text;
}

/// Tells whether the extension is one of a movie, which OpenImageIO lists as "ffmpeg:avi,mov,..."
/// among those of other formats.
bool hasEndingOfAMovie(const std::filesystem::path& file) {
    const std::string formats = fmt::format(";{};", OIIO::get_string_attribute("extension_list"));
    const auto begin = formats.find(";ffmpeg:");
    if (begin == std::string::npos || !file.has_extension()) {
        return false;
    }
    const std::string ending = "," + lowerCase(file.extension().string().substr(1)) + ",";
    const std::string endings = formats.substr(begin + 8, formats.find(';', begin + 1) - begin - 8);
    return ("," + endings + ",").find(ending) != std::string::npos;
}

/// Tells whether a file is a list of movies. Such a list names other files in any folder, with any
/// extension, and a library that opens the list opens those, too.
bool isListOfMovies(std::string_view head) {
    constexpr std::array<std::string_view, 5> heads{"#EXTM3U", "ffconcat", "<?xml", "<MPD",
                                                    "[playlist]"};
    return std::ranges::any_of(heads,
                               [head](std::string_view each) { return head.starts_with(each); });
}

bool isIntegerFormat(const OIIO::ImageSpec& spec) {
    return !spec.format.is_floating_point();
}

/// Returns which of the file's channels become the image's: grey; grey and alpha as four; colour.
std::vector<int> channelsOf(const OIIO::ImageSpec& spec) {
    switch (spec.nchannels) {
    case 1:
        return {0};
    case 2:
        return {0, 0, 0, 1};
    case 3:
        return {0, 1, 2};
    default:
        return spec.alpha_channel == 3 ? std::vector<int>{0, 1, 2, 3} : std::vector<int>{0, 1, 2};
    }
}

Image selected(std::vector<float> pixels, const OIIO::ImageSpec& spec) {
    const std::vector<int> source = channelsOf(spec);
    Image image{spec.width, spec.height, static_cast<int>(source.size()), {}};
    if (image.channels == spec.nchannels) {
        image.pixels = std::move(pixels);
        return image;
    }
    const std::size_t count = std::size_t(spec.width) * std::size_t(spec.height);
    image.pixels.reserve(count * source.size());
    for (std::size_t i = 0; i < count; ++i) {
        for (const int channel : source) {
            image.pixels.push_back(pixels[i * std::size_t(spec.nchannels) + std::size_t(channel)]);
        }
    }
    return image;
}

void divideByAlpha(Image& image) {
    for (std::size_t i = 0; i + 3 < image.pixels.size(); i += 4) {
        const float alpha = image.pixels[i + 3];
        for (std::size_t c = 0; c < 3 && alpha > 0.0f; ++c) {
            image.pixels[i + c] /= alpha;
        }
    }
}

bool isColor(std::size_t i, int channels) { return channels != 4 || i % 4 != 3; }

void decodeSrgb(Image& image, bool eightBit, const SrgbTable& table) {
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        if (!isColor(i, image.channels)) {
            continue;
        }
        float& value = image.pixels[i];
        value = eightBit ? table.decoded(static_cast<std::uint8_t>(value * 255.0f + 0.5f))
                         : static_cast<float>(srgbDecoded(value));
    }
}

/// Returns how many channels a format can hold, at most `channels` for all but .hdr.
int channelsFor(const std::string& extension, int channels) {
    if (extension == ".hdr") {
        return 3;
    }
    const bool jpeg = extension == ".jpg" || extension == ".jpeg";
    return jpeg && channels == 4 ? 3 : channels;
}

std::vector<float> floatsFor(const Image& image, int channels, bool premultiply) {
    const std::size_t count = std::size_t(image.width) * std::size_t(image.height);
    const auto from = std::size_t(image.channels);
    std::vector<float> floats;
    floats.reserve(count * std::size_t(channels));
    for (std::size_t i = 0; i < count; ++i) {
        const float* const pixel = &image.pixels[i * from];
        const float alpha = premultiply && channels == 4 ? pixel[3] : 1.0f;
        for (int c = 0; c < channels; ++c) {
            floats.push_back(c == 3 ? pixel[3] : alpha * pixel[from == 1 ? 0 : c]);
        }
    }
    return floats;
}

OIIO::ImageSpec specFor(const Image& image, int channels, bool eightBit) {
    OIIO::ImageSpec spec(image.width, image.height, channels,
                         eightBit ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::FLOAT);
    spec.attribute("oiio:ColorSpace", eightBit ? "sRGB" : "Linear");
    if (eightBit) {
        spec.attribute("oiio:UnassociatedAlpha", 1); // PNG's alpha is never premultiplied
        spec.attribute("png:compressionLevel", 3);   // half the time of 6 for a few percent in size
        spec.attribute("CompressionQuality", 95);
    }
    return spec;
}

tl::unexpected<Error> encodeError(const std::string& extension, const std::string& why) {
    return tl::unexpected(readError({}, fmt::format("cannot encode as {}: {}", extension, why)));
}

} // namespace

OiioCodec::OiioCodec() {
    OIIO::attribute("threads", 2); // few pictures, one at a time
}

Result<Image> OiioCodec::read(const std::filesystem::path& file) const {
    int bits = 0;
    Result<Image> image = readNumbers(file, bits);
    if (image && bits != 0) {
        decodeSrgb(*image, bits == 8, srgb_);
    }
    return image;
}

Result<Image> OiioCodec::readNumbers(const std::filesystem::path& file, int& bits) const {
    const auto opened = OrdinaryFile::open(file, maxAssetBytes);
    const auto head = opened ? opened->start(16) : tl::unexpected(opened.error());
    if (!head) {
        return tl::unexpected(head.error());
    }
    if (hasEndingOfAMovie(file) || isListOfMovies(*head)) {
        return tl::unexpected(readError(file, "is a movie, not an image"));
    }
    OIIO::ImageSpec wishes;
    wishes.attribute("oiio:UnassociatedAlpha", 1);
    const auto input = OIIO::ImageInput::open(file.string(), &wishes);
    if (!input) {
        return tl::unexpected(readError(file, OIIO::geterror()));
    }
    const OIIO::ImageSpec spec = input->spec();
    if (spec.width <= 0 || spec.height <= 0 || spec.nchannels <= 0 || spec.depth > 1 ||
        spec.image_pixels() > OIIO::imagesize_t(maxPixels) || spec.nchannels > 64 ||
        spec.image_pixels() * OIIO::imagesize_t(spec.nchannels) >
            4 * OIIO::imagesize_t(maxPixels)) {
        return tl::unexpected(readError(file, fmt::format("is too large: {} x {} pixels",
                                                          spec.width, spec.height)));
    }
    std::vector<float> pixels(spec.image_pixels() * std::size_t(spec.nchannels));
    if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, pixels.data())) {
        return tl::unexpected(readError(file, input->geterror()));
    }
    Image image = selected(std::move(pixels), spec);
    bits = isIntegerFormat(spec) ? static_cast<int>(8 * spec.format.basesize()) : 0;
    if (bits == 0 && image.channels == 4 && spec.get_int_attribute("oiio:UnassociatedAlpha") == 0) {
        divideByAlpha(image);
    }
    return image;
}

Result<std::string> OiioCodec::encode(const std::string& extension, const Image& image) const {
    const std::string format = lowerCase(extension);
    static const std::array<std::string_view, 5> known{".png", ".jpg", ".jpeg", ".exr", ".hdr"};
    if (std::ranges::find(known, format) == known.end()) {
        return tl::unexpected(Error{{}, 0, 0,
                                    fmt::format("\"{}\" is not an image format that can be written",
                                                extension),
                                    ".png, .jpg, .exr or .hdr"});
    }
    const auto output = OIIO::ImageOutput::create("picture" + format);
    if (!output) {
        return encodeError(extension, OIIO::geterror());
    }
    const bool eightBit = format != ".exr" && format != ".hdr";
    const int channels = channelsFor(format, image.channels);
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput proxy(bytes);
    if (!output->set_ioproxy(&proxy) ||
        !output->open("picture" + format, specFor(image, channels, eightBit))) {
        return encodeError(extension, output->geterror());
    }
    const bool written =
        eightBit ? output->write_image(OIIO::TypeDesc::UINT8, srgb_.codes(image, channels).data())
                 : output->write_image(OIIO::TypeDesc::FLOAT,
                                       floatsFor(image, channels, format == ".exr").data());
    if (!written || !output->close()) {
        return encodeError(extension, output->geterror());
    }
    return std::string(bytes.begin(), bytes.end());
}

} // namespace patina

extern "C" const patina::ImageCodec* patinaImageCodec() {
    static const patina::OiioCodec codec;
    return &codec;
}
