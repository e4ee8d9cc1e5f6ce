// SPDX-License-Identifier: GPL-3.0-or-later
// Images for surfaces: what is read from files, and their smaller versions.
#include <cstring>

#include <gtest/gtest.h>

#include "assets/asset_client.h"
#include "core/srgb_table.h"
#include "support/program.h"

namespace patina::tests::texture_test {
namespace {

std::vector<int> codesOf(const TexturePicture& picture, std::size_t level) {
    std::vector<int> codes;
    const TexturePicture::Level& at = picture.levels[level];
    const std::size_t count =
        std::size_t(at.size.x) * std::size_t(at.size.y) * texelBytes(picture.format);
    for (std::size_t i = 0; i < count; ++i) {
        codes.push_back(std::to_integer<int>(picture.bytes[at.offset + i]));
    }
    return codes;
}

TEST(Texture, EveryCodeOfAnSrgbFile_StaysItself) {
    FileImage file{{16, 16, 3, {}}, 8};
    std::vector<int> expected;
    for (int y = 15; y >= 0; --y) { // a texture's rows go up
        for (int x = 0; x < 16; ++x) {
            expected.insert(expected.end(), {16 * y + x, 16 * y + x, 16 * y + x, 16 * y + x});
        }
    }
    for (int code = 0; code < 256; ++code) {
        file.image.pixels.insert(file.image.pixels.end(), 3, float(code) / 255.0f);
    }
    const TexturePicture made = madeTexture(file, TextureDecoding::Color);
    EXPECT_EQ(made.format, TexelFormat::Srgb8);
    EXPECT_EQ(codesOf(made, 0), expected);
}

TEST(Texture, SmallerVersionOfSrgb_IsTheMeanOfLight) {
    const FileImage file{{2, 1, 3, {0, 0, 0, 1, 1, 1}}, 8};
    const TexturePicture made = madeTexture(file, TextureDecoding::Color);
    ASSERT_EQ(made.levels.size(), 2u);
    const SrgbTable table;
    EXPECT_EQ(codesOf(made, 1).front(), table.encoded(0.5f));
}

TEST(Texture, SmallerVersionOfData_IsTheMeanOfNumbers) {
    const FileImage file{{2, 1, 1, {0.0f, 1.0f}}, 8};
    const TexturePicture made = madeTexture(file, TextureDecoding::Linear);
    EXPECT_EQ(made.format, TexelFormat::Grey8);
    EXPECT_EQ(codesOf(made, 1), std::vector<int>{128});
}

TEST(Texture, SmallerVersionOfOddSize_KeepsTheMean) {
    FileImage file{{5, 3, 1, {}}, 0};
    double sum = 0.0;
    for (int i = 0; i < 15; ++i) {
        file.image.pixels.push_back(float(i * i));
        sum += i * i;
    }
    const TexturePicture made = madeTexture(file, TextureDecoding::Linear);
    float last = 0.0f;
    std::memcpy(&last, made.bytes.data() + made.levels.back().offset, sizeof last);
    EXPECT_NEAR(last, sum / 15.0, 1e-4);
}

TEST(Texture, WhatIsNoNumber_IsBlackAndNothingIsEndless) {
    const FileImage file{{1, 1, 3, {std::nanf(""), INFINITY, 1e30f}}, 0};
    const TexturePicture made = madeTexture(file, TextureDecoding::Linear);
    float texel[4];
    std::memcpy(texel, made.bytes.data(), sizeof texel);
    EXPECT_EQ(texel[0], 0.0f);
    EXPECT_EQ(texel[1], 0.0f);
    EXPECT_EQ(texel[2], 65504.0f);
}

TEST(Texture, Alpha_IsSeenWhereItIsBelowOne) {
    EXPECT_FALSE(
        madeTexture({{1, 1, 4, {1, 1, 1, 1}}, 8}, TextureDecoding::Color).hasAlpha);
    EXPECT_TRUE(
        madeTexture({{1, 1, 4, {1, 1, 1, 0.5f}}, 8}, TextureDecoding::Color).hasAlpha);
}

/// The number that a grey picture, or one without alpha, gives where alpha is asked for.
float alphaOf(const FileImage& file, TextureDecoding decoding) {
    const TexturePicture made = madeTexture(file, decoding);
    const std::size_t bytes = texelBytes(made.format);
    if (made.format == TexelFormat::Color32 || made.format == TexelFormat::Grey32) {
        float last = 0.0f; // the only number of a grey texel stands for its alpha too
        std::memcpy(&last, made.bytes.data() + bytes - sizeof last, sizeof last);
        return last;
    }
    return float(std::to_integer<int>(made.bytes[bytes - 1])) / 255.0f;
}

TEST(Texture, WithoutAlpha_ItsGreyStandsThere) {
    const float code = 51.0f / 255.0f;
    for (const int bits : {0, 8, 16}) {
        const FileImage grey{{1, 1, 3, {code, code, code}}, bits};
        EXPECT_EQ(alphaOf(grey, TextureDecoding::Linear), code) << bits;
        EXPECT_EQ(alphaOf(grey, TextureDecoding::Color), code) << bits;
        const FileImage opaque{{1, 1, 4, {code, code, code, 1.0f}}, bits};
        EXPECT_EQ(alphaOf(opaque, TextureDecoding::Color), code) << bits;
        const FileImage masked{{1, 1, 4, {1.0f, 1.0f, 1.0f, code}}, bits};
        EXPECT_EQ(alphaOf(masked, TextureDecoding::Color), code) << bits;
    }
}

TEST(Texture, OneChannel_GivesItsCodesAsAlphaWhileItsLightIsDecoded) {
    const float code = 51.0f / 255.0f;
    for (const int bits : {8, 16}) {
        const FileImage grey{{1, 1, 1, {code}}, bits};
        EXPECT_EQ(alphaOf(grey, TextureDecoding::Color), code) << bits;
        EXPECT_NEAR(alphaOf(grey, TextureDecoding::Srgb), SrgbTable().decoded(51), 2e-3) << bits;
    }
}

/// The weights are those of Rec. 709.
TEST(Texture, ColorWithoutAlpha_GivesItsLuminance) {
    const FileImage green{{1, 1, 3, {0.0f, 1.0f, 0.0f}}, 0};
    EXPECT_NEAR(alphaOf(green, TextureDecoding::Color), 0.7152f, 1e-6);
}

TEST(Texture, PngReadAsData_HasTheCodesOfTheFile) {
    const TemporaryFolder folder;
    AssetClient client;
    // 0.2158605 is code 128 in sRGB.
    ASSERT_TRUE(client.saveImage(folder / "a.png", Image{1, 1, 3, {0.2158605f, 0.0f, 1.0f}}));
    const auto picture = client.loadTexture(folder / "a.png", TextureDecoding::Linear);
    ASSERT_TRUE(picture) << picture.error().text();
    EXPECT_EQ((*picture)->format, TexelFormat::Color8);
    // 0.2126 * 128 + 0.0722 * 255 = 45.6 for the alpha that it lacks.
    EXPECT_EQ(codesOf(**picture, 0), (std::vector<int>{128, 0, 255, 46}));
}

TEST(Texture, Exr_StaysFloats) {
    const TemporaryFolder folder;
    AssetClient client;
    ASSERT_TRUE(client.saveImage(folder / "a.exr", Image{1, 1, 3, {0.1f, 2.0f, 30.0f}}));
    const auto picture = client.loadTexture(folder / "a.exr", TextureDecoding::Color);
    ASSERT_TRUE(picture) << picture.error().text();
    EXPECT_EQ((*picture)->format, TexelFormat::Color32);
}

TEST(Texture, MissingFile_IsNamed) {
    AssetClient client;
    const auto picture = client.loadTexture("/nowhere/a.png", TextureDecoding::Color);
    ASSERT_FALSE(picture);
    EXPECT_EQ(picture.error().text(), "/nowhere/a.png: no such file");
}

TEST(Texture, CancelledBeforeItBegan_SaysSo) {
    const TemporaryFolder folder;
    AssetClient client;
    ASSERT_TRUE(client.saveImage(folder / "a.png", Image{1, 1, 3, {1, 1, 1}}));
    Progress progress;
    progress.cancelled = true;
    const auto picture =
        client.loadTexture(folder / "a.png", TextureDecoding::Color, &progress);
    ASSERT_FALSE(picture);
    EXPECT_NE(picture.error().problem.find("cancelled"), std::string::npos);
}

} // namespace
} // namespace patina::tests::texture_test
