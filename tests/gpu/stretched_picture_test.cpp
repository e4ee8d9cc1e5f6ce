// SPDX-License-Identifier: GPL-3.0-or-later
// A picture that is shown in another size.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <epoxy/gl.h>

#include "gpu_fixture.h"
#include "render/gpu/stretched_picture.h"

namespace patina::stretched_picture_test {
namespace {

constexpr glm::ivec2 size{5, 4};
constexpr glm::ivec2 larger{17, 11};

class StretchedPictureTest : public GpuTest {
  protected:
    /// Fills a picture with squares of two colours.
    static void fill(const StretchedPicture& picture) {
        glBindFramebuffer(GL_FRAMEBUFFER, picture.framebuffer());
        glEnable(GL_SCISSOR_TEST);
        for (int i = 0; i < size.x * size.y; ++i) {
            const float shade = i % 3 == 0 ? 0.9f : 0.1f;
            glScissor(i % size.x, i / size.x, 1, 1);
            glClearColor(shade, 1.0f - shade, 0.05f * float(i), 1.0f);
            glClear(GL_COLOR_BUFFER_BIT);
        }
        glDisable(GL_SCISSOR_TEST);
    }

    static std::vector<unsigned char> pixels(glm::ivec2 read = larger) {
        std::vector<unsigned char> bytes(std::size_t(4) * read.x * read.y);
        glReadPixels(0, 0, read.x, read.y, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
        return bytes;
    }
};

TEST_F(StretchedPictureTest, DrawnByAProgram_IsAsTheDriverStretchesIt) {
    const StretchedPicture picture(size);
    fill(picture);
    const StretchedPicture target(larger);
    picture.show(target.framebuffer(), larger);
    const auto shown = pixels();
    ProgramCache cache({});
    ASSERT_TRUE(picture.draw({target.framebuffer(), larger}, *catalog, cache));
    const auto drawn = pixels();
    for (std::size_t i = 0; i < shown.size(); ++i) {
        EXPECT_NEAR(drawn[i], shown[i], 1) << i;
    }
}

/// Rows of what is drawn over come from the top, its colours multiplied by their opacity.
TEST_F(StretchedPictureTest, Overlay_IsBlendedFromTheTopRowOn) {
    const StretchedPicture picture(size);
    fill(picture);
    const auto before = pixels(size);
    std::vector<unsigned char> lines(std::size_t(4) * size.x * size.y, 0);
    const std::array<unsigned char, 4> halfRed{0, 0, 100, 128}; // blue, green, red, opacity
    std::ranges::copy(halfRed, lines.begin());
    OverlayPicture overlay;
    EXPECT_TRUE(overlay.isEmpty());
    overlay.take(size, lines.data());
    ProgramCache cache({});
    ASSERT_TRUE(overlay.draw({picture.framebuffer(), size}, *catalog, cache));
    auto expected = before;
    const std::size_t topLeft = std::size_t(4) * size.x * (size.y - 1);
    for (std::size_t channel = 0; channel < 3; ++channel) {
        unsigned char& value = expected[topLeft + channel];
        value = static_cast<unsigned char>(value * 127 / 255 + halfRed[2 - channel]);
    }
    const auto after = pixels(size);
    for (std::size_t i = 0; i < after.size(); ++i) {
        EXPECT_NEAR(after[i], expected[i], 1) << i;
    }
    overlay.take({}, nullptr);
    EXPECT_TRUE(overlay.isEmpty());
}

/// The view only gets wider or narrower.
TEST_F(StretchedPictureTest, Undistorted_IsCutOffOrHasItsEdgesDrawnOut) {
    const StretchedPicture picture(size);
    fill(picture);
    const auto whole = pixels(size);
    ProgramCache cache({});
    for (const int width : {3, 4, 9}) {
        const glm::ivec2 shownSize(width, size.y);
        const StretchedPicture target(shownSize);
        ASSERT_TRUE(picture.drawUndistorted({target.framebuffer(), shownSize}, *catalog, cache));
        const auto shown = pixels(shownSize);
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < width; ++x) {
                const int beside = static_cast<int>(std::floor((width - size.x) / 2.0));
                const int from = std::clamp(x - beside, 0, size.x - 1);
                EXPECT_EQ(shown[std::size_t(4) * (y * width + x)],
                          whole[std::size_t(4) * (y * size.x + from)])
                    << width << ": " << x << ' ' << y;
            }
        }
    }
}

} // namespace
} // namespace patina::stretched_picture_test
