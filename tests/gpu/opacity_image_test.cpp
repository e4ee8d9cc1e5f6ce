// SPDX-License-Identifier: GPL-3.0-or-later
// Images of the opacity: by their alpha, or their grey where they have none.
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

} // namespace
} // namespace patina::opacity_image_test
