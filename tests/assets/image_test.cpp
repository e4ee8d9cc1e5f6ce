// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <filesystem>

#include <sys/resource.h>

#include <gtest/gtest.h>

#include "assets/asset_client.h"
#include "support/program.h"

namespace patina::tests::image_test {
namespace {

/// A gradient in all channels, alpha included, so that no two neighbours are equal.
Image gradient(int width, int height, int channels) {
    Image image{width, height, channels, {}};
    const int count = width * height * channels;
    for (int i = 0; i < count; ++i) {
        image.pixels.push_back(static_cast<float>(i + 1) / static_cast<float>(count));
    }
    return image;
}

float largestDifference(const Image& a, const Image& b) {
    float largest = a.pixels.size() == b.pixels.size() ? 0.0f : 1e30f;
    for (std::size_t i = 0; i < std::min(a.pixels.size(), b.pixels.size()); ++i) {
        largest = std::max(largest, std::abs(a.pixels[i] - b.pixels[i]));
    }
    return largest;
}

Result<Image> roundTrip(const std::string& name, const Image& image) {
    const TemporaryFolder folder;
    AssetClient client;
    return client.saveImage(folder / name, image).and_then([&] {
        return client.loadImage(folder / name);
    });
}

/// Half a step of an 8-bit code where the sRGB curve is steepest: 0.5 / 255 * 2.2.
constexpr float eightBitTolerance = 0.0045f;

TEST(ImageFile, PngWithAlpha_ReadsBackWithinHalfAStep) {
    const Image image = gradient(16, 9, 4);
    const auto read = roundTrip("a.png", image);
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_LE(largestDifference(*read, image), eightBitTolerance);
}

TEST(ImageFile, GreyPng_ReadsBackWithinHalfAStep) {
    const Image image = gradient(16, 9, 1);
    const auto read = roundTrip("a.png", image);
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->channels, 1);
    EXPECT_LE(largestDifference(*read, image), eightBitTolerance);
}

TEST(ImageFile, ExrWithAlpha_ReadsBackToTheLastBits) {
    const Image image = gradient(16, 9, 4);
    const auto read = roundTrip("a.exr", image);
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_LE(largestDifference(*read, image), 2e-7f); // multiplied by alpha, then divided
}

TEST(ImageFile, ExrWithoutAlpha_ReadsBackTheSameFloats) {
    Image image = gradient(16, 9, 3);
    image.pixels[0] = 1e6f;
    image.pixels[1] = 1e-6f;
    const auto read = roundTrip("a.exr", image);
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(*read, image);
}

TEST(ImageFile, Hdr_ReadsBackWithinItsSharedExponent) {
    const Image image = gradient(16, 9, 3);
    const auto read = roundTrip("a.hdr", image);
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_LE(largestDifference(*read, image), 1.0f / 128.0f); // 8 bits of mantissa below 1
}

TEST(ImageFile, JpegOfOneColor_ReadsBackThatColor) {
    Image image{16, 16, 3, {}};
    image.pixels.assign(16 * 16 * 3, 0.5f);
    const auto read = roundTrip("a.jpg", image);
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_LE(largestDifference(*read, image), 2.0f * eightBitTolerance); // chroma rounding too
}

TEST(ImageFile, EncodedPng_StartsAsOne) {
    AssetClient client;
    const auto bytes = client.encodeImage(".png", gradient(4, 4, 3));
    ASSERT_TRUE(bytes) << bytes.error().text();
    EXPECT_EQ(bytes->substr(1, 3), "PNG");
}

TEST(ImageFile, ColorsBeyondTheRange_AreClampedInPng) {
    Image image{2, 1, 3, {-1.0f, 2.0f, std::nanf(""), 1e30f, -1e30f, 0.0f}};
    const auto read = roundTrip("a.png", image);
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->pixels, (std::vector<float>{0, 1, 0, 1, 0, 0}));
}

TEST(ImageFile, UnknownExtension_SaysWhatIsKnown) {
    AssetClient client;
    const auto saved = client.saveImage("/tmp/a.xyz", gradient(4, 4, 3));
    ASSERT_FALSE(saved);
    EXPECT_EQ(saved.error().text(), "/tmp/a.xyz: \".xyz\" is not an image format that can be "
                                    "written; expected .png, .jpg, .exr or .hdr");
}

TEST(ImageFile, FolderThatIsNotThere_SaysSo) {
    AssetClient client;
    const auto saved = client.saveImage("/nowhere/a.png", gradient(4, 4, 3));
    ASSERT_FALSE(saved);
    EXPECT_EQ(saved.error().text(),
              "/nowhere/a.png: cannot be saved in its folder: No such file or directory");
}

TEST(ImageFile, FolderThatCannotBeWritten_SaysSo) {
    AssetClient client; // nobody, not even root, makes files in /proc
    const auto saved = client.saveImage("/proc/a.png", gradient(4, 4, 3));
    ASSERT_FALSE(saved);
    EXPECT_TRUE(saved.error().problem.starts_with("cannot be saved in its folder: "));
}

/// A files process that may write no file of more than 4 KiB, as on a disk that is full.
void startOnFullDisk(AssetClient& client) {
    rlimit before{};
    ::getrlimit(RLIMIT_FSIZE, &before);
    const rlimit small{4096, before.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &small);
    const TemporaryFolder folder;
    writeFile(folder / "a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    EXPECT_TRUE(client.loadMesh({folder / "a.obj"}));
    ::setrlimit(RLIMIT_FSIZE, &before);
}

TEST(ImageFile, FullDisk_KeepsTheOldFileAndLeavesNoOther) {
    const TemporaryFolder folder;
    writeFile(folder / "a.exr", "old");
    AssetClient client;
    startOnFullDisk(client);
    const auto saved = client.saveImage(folder / "a.exr", gradient(256, 256, 3));
    ASSERT_FALSE(saved);
    EXPECT_EQ(saved.error().problem, "cannot be saved, the old file is unchanged: File too large");
    EXPECT_EQ(readFile(folder / "a.exr"), "old");
    const auto entries = std::filesystem::directory_iterator(folder.path());
    EXPECT_EQ(std::distance(begin(entries), end(entries)), 1);
}

TEST(ImageFile, ThatCannotBeReplaced_IsIntact) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "a.png"); // a file never replaces a folder
    AssetClient client;
    ASSERT_FALSE(client.saveImage(folder / "a.png", gradient(4, 4, 3)));
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST(ImageFile, SavedThroughALink_ReplacesWhatItPointsTo) {
    const TemporaryFolder folder;
    writeFile(folder / "real.png", "old");
    std::filesystem::create_symlink("real.png", folder / "link.png");
    AssetClient client;
    ASSERT_TRUE(client.saveImage(folder / "link.png", gradient(4, 4, 3)));
    EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.png"));
    EXPECT_TRUE(client.loadImage(folder / "real.png"));
}

TEST(ImageFile, WithoutPixels_IsRefused) {
    AssetClient client;
    EXPECT_FALSE(client.saveImage("/tmp/a.png", Image{}));
}

TEST(ImageFile, WithFewerPixelsThanItsSize_IsRefused) {
    AssetClient client;
    EXPECT_FALSE(client.saveImage("/tmp/a.png", Image{4, 4, 3, {1.0f}}));
}

TEST(ImageFile, CutShort_EndsInAMessageOrAnImage) {
    const TemporaryFolder folder;
    AssetClient client;
    for (const char* extension : {".png", ".exr", ".hdr", ".jpg"}) {
        const std::string bytes = *client.encodeImage(extension, gradient(64, 64, 3));
        const std::filesystem::path file = folder / ("cut" + std::string(extension));
        writeFile(file, bytes.substr(0, bytes.size() / 2));
        const auto image = client.loadImage(file);
        EXPECT_TRUE(image || image.error().file == file.string()) << extension;
    }
}

TEST(ImageFile, OfNoise_SaysSo) {
    const TemporaryFolder folder;
    AssetClient client;
    for (const char* extension : {".png", ".exr", ".hdr", ".jpg"}) {
        const std::filesystem::path file = folder / ("noise" + std::string(extension));
        writeFile(file, "this is no picture");
        EXPECT_FALSE(client.loadImage(file)) << extension;
    }
}

} // namespace
} // namespace patina::tests::image_test
