// SPDX-License-Identifier: GPL-3.0-or-later
// Strands that an image combs.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "texture_fixture.h"

namespace patina::combed_shells_test {
namespace {

constexpr int combedSize = 64;

class CombedShells : public TextureTest {
  protected:
    void SetUp() override {
        TextureTest::SetUp();
        scene.camera.distance = 2.5; // the quad is two fifths of the view
        scene.background = glm::dvec3(0.0);
        color(glm::dvec3(1.0));
        BlockValues fur = block("shells", "fur");
        fur.parameters["strand.length"] = 0.5;
        fur.parameters["density"] = 6.0;
        fur.parameters["variation"] = 0.0;
        fur.parameters["thickness"] = 1.0;
        fur.parameters["taper"] = 0.0;
        fur.parameters["comb"] = 1.0;
        fur.parameters["comb.direction"] = glm::dvec3(0.0);
        fur.parameters["fins"] = false;
        scene.objects.front().material.parts["shells"] = fur;
        scene.objects.front().material.accuracy["layers"] = "16";
    }

    Value& value(const std::string& id) {
        return scene.objects.front().material.parts.at("shells").parameters[id];
    }

    /// Lays an even image on the combing.
    TextureUse& comb(const glm::vec3& texel) {
        const std::string name = fmt::format("{} {} {}", texel.x, texel.y, texel.z);
        file(name, {1, 1}, 3, {texel.x, texel.y, texel.z});
        return use("shells.comb.direction", name);
    }

    /// Returns how far the middle of what is seen lies right of and above the view's, in pixels.
    glm::dvec2 lean() {
        const Image image = drawn(combedSize);
        glm::dvec2 sum(0.0);
        double seen = 0.0;
        for (int y = 0; y < image.height; ++y) {
            for (int x = 0; x < image.width; ++x) {
                const double there = pixel(image, x, y).g > 1e-4f ? 1.0 : 0.0;
                sum += there * glm::dvec2(x + 0.5 - 0.5 * combedSize, 0.5 * combedSize - y - 0.5);
                seen += there;
            }
        }
        EXPECT_GT(seen, 400.0);
        return sum / seen;
    }

    void expectLean(const glm::dvec2& direction) {
        const glm::dvec2 found = lean();
        EXPECT_GT(glm::dot(found, direction), 1.5) << found.x << ' ' << found.y;
        EXPECT_LT(std::abs(found.x * direction.y - found.y * direction.x), 0.3)
            << found.x << ' ' << found.y;
    }
};

TEST_F(CombedShells, AnImagesRedAndGreen_AreWhereStrandsLean) {
    comb({1.0f, 0.5f, 0.0f});
    expectLean({1.0, 0.0});
    comb({0.0f, 0.5f, 0.0f});
    expectLean({-1.0, 0.0});
    comb({0.5f, 1.0f, 0.0f});
    expectLean({0.0, 1.0});
    comb({0.5f, 0.0f, 0.0f});
    expectLean({0.0, -1.0});
    EXPECT_EQ(std::ranges::count(asked, TextureDecoding::Linear), std::ssize(asked));
}

TEST_F(CombedShells, AnEvenImage_IsTheSameDirectionTyped) {
    comb({1.0f, 0.5f, 0.5f});
    const Image image = drawn(combedSize);
    scene.objects.front().material.textures.clear();
    value("comb.direction") = glm::dvec3(1.0, 0.0, 0.0);
    const Image typed = drawn(combedSize);
    EXPECT_EQ(image.pixels, typed.pixels);
}

TEST_F(CombedShells, MiddleGrey_LeavesStrandsUpright) {
    value("comb.direction") = glm::dvec3(1.0, 0.0, 0.0);
    comb({0.5f, 0.5f, 0.5f});
    EXPECT_LT(glm::length(lean()), 0.3);
}

TEST_F(CombedShells, ATurnedImage_TurnsItsDirections) {
    comb({1.0f, 0.5f, 0.0f}).rotation = 90.0;
    const glm::dvec2 turned = lean();
    EXPECT_LT(std::abs(turned.x), 0.3);
    EXPECT_GT(std::abs(turned.y), 1.5);
}

/// Added to a typed direction it changes it, and multiplied it says how far that is followed.
TEST_F(CombedShells, Modes_AddToTheDirectionAndScaleIt) {
    value("comb.direction") = glm::dvec3(0.0, 1.0, 0.0);
    comb({1.0f, 0.5f, 0.0f}).mode = TextureMode::Add;
    expectLean(glm::dvec2(std::sqrt(0.5)));
    comb({0.5f, 0.5f, 0.0f}).mode = TextureMode::Multiply;
    EXPECT_LT(glm::length(lean()), 0.3);
    comb({1.0f, 0.5f, 0.0f}).mode = TextureMode::Multiply;
    expectLean({0.0, 1.0});
}

TEST_F(CombedShells, ImagesOfNoNumbersAndMissingOnes_AreDrawn) {
    const float none = std::nanf("");
    for (const glm::vec3& texel : {glm::vec3(none), glm::vec3(3e38f), glm::vec3(-3e38f, none, 0)}) {
        comb(texel);
        for (const float channel : drawn(combedSize).pixels) {
            ASSERT_TRUE(std::isfinite(channel) && channel >= 0.0f);
        }
    }
    use("shells.comb.direction", "missing");
    for (const float channel : drawn(combedSize).pixels) {
        ASSERT_TRUE(std::isfinite(channel) && channel >= 0.0f);
    }
}

} // namespace
} // namespace patina::combed_shells_test
