// SPDX-License-Identifier: GPL-3.0-or-later
// Images of the opacity: by their alpha, or their grey where they have none.
#include "shading/effects/effect_rows.h"
#include "shading/effects/opacity.h"
#include "texture_fixture.h"

namespace patina::opacity_image_test {
namespace {

class OpacityImage : public TextureTest {};

TEST_F(OpacityImage, CutOut_LeavesTheBackgroundWhereItIsBelow) {
    file("mask", {2, 1}, 4, {1, 1, 1, 0.4f, 1, 1, 1, 0.6f});
    TextureUse& mask = use("opacity", "mask");
    mask.cutOut = true;
    mask.threshold = 0.5;
    const Image image = drawn();
    expectNear(at(image, 0.25, 0.5) * brightness, glm::vec3(0.25f)); // the background
    expectNear(at(image, 0.75, 0.5), glm::vec3(0.5f));
}

TEST_F(OpacityImage, Alpha_BlendsWithTheBackground) {
    file("mask", {1, 1}, 4, {1, 1, 1, 0.25f});
    use("opacity", "mask");
    const float expected = 0.25f * 0.5f * brightness + 0.75f * 0.25f;
    expectNear(at(drawn(), 0.5, 0.5) * brightness, glm::vec3(expected));
}

/// Files of one channel, of colours and of floats have no alpha.
TEST_F(OpacityImage, WithoutAlpha_BlendsByItsGrey) {
    file("grey", {1, 1}, 1, {0.25f});
    file("grey of 8 bits", {1, 1}, 1, {64.0f / 255.0f}, 8);
    file("colour", {1, 1}, 3, {0.25f, 0.25f, 0.25f});
    file("colour of 8 bits", {1, 1}, 3, std::vector<float>(3, 64.0f / 255.0f), 8);
    file("opaque", {1, 1}, 4, {0.25f, 0.25f, 0.25f, 1.0f});
    for (const auto& [name, image] : files) {
        use("opacity", name);
        const float there = image.bits == 8 ? 64.0f / 255.0f : 0.25f;
        const float expected = there * 0.5f * brightness + (1.0f - there) * 0.25f;
        SCOPED_TRACE(name);
        expectNear(at(drawn(), 0.5, 0.5) * brightness, glm::vec3(expected));
    }
}

TEST_F(OpacityImage, GreyMaskThatCutsOut_LeavesTheBackgroundWhereItIsBelow) {
    file("mask", {2, 1}, 1, {0.4f, 0.6f});
    use("opacity", "mask").cutOut = true;
    const Image image = drawn();
    expectNear(at(image, 0.25, 0.5) * brightness, glm::vec3(0.25f)); // the background
    expectNear(at(image, 0.75, 0.5), glm::vec3(0.5f));
}

TEST_F(OpacityImage, AlphaThatIsAskedForByName_IsOneWhereThereIsNone) {
    file("grey", {1, 1}, 1, {0.25f});
    file("colour", {1, 1}, 3, {0.25f, 0.25f, 0.25f}, 8);
    for (const auto& [name, image] : files) {
        use("opacity", name).channel = TextureChannel::Alpha;
        SCOPED_TRACE(name);
        expectNear(at(drawn(), 0.5, 0.5), glm::vec3(0.5f));
    }
}

/// One image, asked for its grey and for its alpha in the same program.
TEST_F(OpacityImage, ImageWithoutAlpha_GivesEachUseItsOwn) {
    file("grey", {1, 1}, 1, {0.25f});
    use("opacity", "grey");
    use("diffuse.color", "grey").channel = TextureChannel::Alpha;
    const float expected = 0.25f * brightness + 0.75f * 0.25f;
    expectNear(at(drawn(), 0.5, 0.5) * brightness, glm::vec3(expected));
}

/// Images of the share that a model itself transmits.
class TransparencyImage : public TextureTest {
  protected:
    void SetUp() override {
        TextureTest::SetUp();
        scene.objects.front().material.model = block("models", "strauss");
        values()["smoothness"] = 0.6;
        values()["metalness"] = 0.3;
        values()["k"] = 0.4;
        values()["emissive.color"] = glm::dvec3(0.05);
        values()["transparency"] = 0.7;
        scene.objects.front().material.opacity = 0.9;
        scene.objects.front().rotation.y = 10.0;
        file("share", {4, 1}, 1, {0.0f, 0.4f, 0.7f, 1.0f});
    }

    Values& values() { return scene.objects.front().material.model.parameters; }

    std::string opacityReason() const {
        for (const EffectRow& row : effectRows(scene, 0, *catalog)) {
            if (row.line.effect == "opacity") {
                return row.line.reason;
            }
        }
        return {};
    }
};

/// Strauss' formula has t in the diffuse part and in the highlight.
TEST_F(TransparencyImage, AtEachPixel_IsTheModelOfThatValue) {
    for (const auto& [mode, factor] :
         {std::pair(TextureMode::Replace, 1.0), std::pair(TextureMode::Multiply, 0.7)}) {
        values()["transparency"] = 0.7;
        use("transparency", "share").mode = mode;
        const Image imaged = drawn();
        scene.objects.front().material.textures.clear();
        for (const auto& [u, share] :
             {std::pair(0.3, 0.4), std::pair(0.6, 0.7), std::pair(0.8, 1.0)}) {
            values()["transparency"] = factor * share;
            SCOPED_TRACE(share);
            expectNear(at(imaged, u, 0.5), at(drawn(), u, 0.5));
        }
    }
}

TEST_F(TransparencyImage, OnAValueThatPassesNothing_ShowsWhatIsBehind) {
    values()["transparency"] = 0.0;
    scene.objects.front().material.opacity = 1.0;
    EXPECT_FALSE(isTransparent(scene.objects.front().material, *catalog));
    use("transparency", "share");
    EXPECT_TRUE(isTransparent(scene.objects.front().material, *catalog));
    EXPECT_EQ(opacityReason(), "The material's opacity is 1, and an image says what its model "
                               "transmits.");
    const std::vector<std::string> off{"opacity"};
    const Scene without = withoutEffects(scene, off, *catalog);
    EXPECT_FALSE(isTransparent(without.objects.front().material, *catalog));
}

} // namespace
} // namespace patina::opacity_image_test
