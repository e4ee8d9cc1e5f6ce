// SPDX-License-Identifier: GPL-3.0-or-later
// The corners of the sheet that ships, metalness by smoothness, are what Strauss' paper says of
// them: a matte dielectric, a shiny plastic, a dull metal and a polished one.
#include <algorithm>

#include "core/color.h"
#include "gpu_fixture.h"
#include "material/preset_file.h"
#include "sheet/sheet_file.h"
#include "sheet/sheet_plan.h"

namespace patina::strauss_sheet_test {
namespace {

/// What of a ball under one light is seen in a cell.
struct Look {
    glm::dvec3 body{0.0};      ///< halfway to the rim, away from the highlight of a smooth surface
    glm::dvec3 highlight{0.0}; ///< where the surface mirrors the light
    double share = 0.0;        ///< of the ball that is brighter than half the highlight
};

/// How much of a colour is red, of red and blue: 0.5 of a grey.
double redness(const glm::dvec3& color) {
    return color.r / (color.r + color.b);
}

class StraussSheet : public GpuTest {
  protected:
    void SetUp() override {
        GpuTest::SetUp();
        makeRenderer();
        const auto reading =
            readSheet(PATINA_SOURCE_DIR "/presets/sheets/strauss.patina-sheet.json");
        ASSERT_TRUE(reading) << text(reading.error());
        const auto preset = readPreset(reading->sheet.preset, *catalog);
        ASSERT_TRUE(preset) << text(preset.error());
        Scene scene = simpleScene();
        scene.background = glm::dvec3(0.0);
        scene.objects[0].material = preset->material;
        color_ = std::get<glm::dvec3>(preset->material.model.parameters.at("diffuse.color"));
        auto made = SheetPlan::of(reading->sheet, scene, 0, catalog);
        ASSERT_TRUE(made) << text(made.error());
        plan_ = std::move(*made);
        ASSERT_EQ(plan_.x().axis.value, "metalness");
        ASSERT_EQ(plan_.y()->axis.value, "smoothness");
    }

    Look look(int column, int row) {
        constexpr int size = 97;
        const Image image = capture(plan_.scene(column, row).value(), false, size);
        Look seen;
        seen.highlight = middle(image);
        int ball = 0;
        int bright = 0;
        int right = 0;
        for (int x = size / 2; x < size && pixel(image, x, size / 2).r > 0.0f; ++x) {
            right = x;
        }
        seen.body = pixel(image, size / 2 + (2 * (right - size / 2)) / 3, size / 2);
        for (int y = 0; y < size; ++y) {
            for (int x = 0; x < size; ++x) {
                const glm::dvec3 color = pixel(image, x, y);
                ball += color.r > 0.0 ? 1 : 0;
                bright += luminance(color) > 0.5 * luminance(seen.highlight) ? 1 : 0;
            }
        }
        seen.share = double(bright) / double(std::max(ball, 1));
        return seen;
    }

    Look matteDielectric() { return look(0, 0); }
    Look shinyPlastic() { return look(0, plan_.rows() - 2); } // the last row is the start
    Look dullMetal() { return look(plan_.columns() - 1, 0); }
    Look polishedMetal() { return look(plan_.columns() - 1, plan_.rows() - 2); }

    SheetPlan plan_;
    glm::dvec3 color_{0.0};
};

/// Diffuse (1 - s^3) c of all light, and a highlight of at most s^3 and a bit of it.
TEST_F(StraussSheet, RoughAndNoMetal_IsMatteInItsColour) {
    const Look seen = matteDielectric();
    EXPECT_NEAR(redness(seen.body), redness(color_), 0.02);
    EXPECT_GT(seen.share, 0.4); // light falls off as on a matte ball
    EXPECT_NEAR(luminance(seen.highlight) / luminance(color_), 1.0, 0.2);
}

TEST_F(StraussSheet, SmoothAndNoMetal_IsPlasticWithASmallWhiteHighlight) {
    const Look seen = shinyPlastic();
    EXPECT_NEAR(redness(seen.body), redness(color_), 0.02);
    EXPECT_LT(redness(seen.highlight) - 0.5, 0.25 * (redness(color_) - 0.5));
    EXPECT_GT(luminance(seen.highlight), 4.0 * luminance(seen.body));
    EXPECT_LT(seen.share, 0.1);
}

TEST_F(StraussSheet, RoughMetal_IsDullInItsColourAllOver) {
    const Look seen = dullMetal();
    EXPECT_NEAR(redness(seen.highlight), redness(color_), 0.05);
    EXPECT_NEAR(redness(seen.body), redness(color_), 0.05);
    EXPECT_GT(seen.share, 0.3);
    EXPECT_LT(luminance(seen.body), luminance(matteDielectric().body)); // less of it is matte
}

TEST_F(StraussSheet, SmoothMetal_IsDarkWithASmallHighlightInItsColour) {
    const Look seen = polishedMetal();
    EXPECT_NEAR(redness(seen.highlight), redness(color_), 0.05);
    EXPECT_LT(seen.share, 0.1);
    EXPECT_LT(luminance(seen.body), 0.25 * luminance(shinyPlastic().body));
    EXPECT_GT(luminance(seen.highlight), 20.0 * luminance(seen.body));
}

} // namespace
} // namespace patina::strauss_sheet_test
