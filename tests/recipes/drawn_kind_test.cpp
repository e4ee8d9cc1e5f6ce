// SPDX-License-Identifier: GPL-3.0-or-later
// The kind of block that CONTRIBUTING.md shows, as it stands there: with its effect it is in a
// program, and a picture changes with its values.
#include <gtest/gtest.h>

#include "gpu/gpu_fixture.h"
#include "material/preset_file.h"
#include "shading/effects/effect_rows.h"
#include "shading/effects/surface_program.h"

namespace patina::tests::drawn_kind_test {
namespace {

class DrawnKind : public GpuTest {
  protected:
    void SetUp() override {
        GpuTest::SetUp();
        catalog = std::make_shared<const Catalog>(loadCatalog(std::array{
            BlockRoot{PATINA_SOURCE_DIR "/shaders", true}, BlockRoot{PATINA_GUIDE_SHADERS, true}}));
        ASSERT_EQ(text(catalog->errors), "");
        makeRenderer();
    }

    /// A ball, of velvet with this tint.
    Scene velvet(const glm::dvec3& tint) const {
        Scene scene = simpleScene();
        scene.objects[0].material.parts["sheen"] = block("sheen", "velvet");
        scene.objects[0].material.parts["sheen"].parameters["tint"] = tint;
        return scene;
    }

    std::string fragmentOf(const Scene& scene) const {
        const auto source =
            surfaceProgram(effectSet(scene.objects[0].material, scene, *catalog), *catalog);
        EXPECT_TRUE(source) << (source ? "" : text(source.error()));
        return source ? source->fragment.text : std::string();
    }
};

TEST_F(DrawnKind, ItsBlock_IsInTheProgramOfItsMaterialAlone) {
    EXPECT_NE(fragmentOf(velvet(glm::dvec3(1.0))).find("velvetSheenShare(sheen)"),
              std::string::npos);
    EXPECT_EQ(fragmentOf(simpleScene()).find("Sheen"), std::string::npos);
}

TEST_F(DrawnKind, ItsBlock_BrightensThePictureByItsFormula) {
    const Image plain = capture(simpleScene());
    const Image drawn = capture(velvet({1.0, 0.0, 0.0}));
    EXPECT_EQ(middle(drawn), middle(plain)) << "where the surface faces the eye";
    float largest = 1.0f;
    for (int x = 0; x < plain.width; ++x) {
        const glm::vec3 before = pixel(plain, x, plain.height / 2);
        const glm::vec3 after = pixel(drawn, x, plain.height / 2);
        EXPECT_EQ(after.y, before.y) << "the tint is red";
        largest = std::max(largest, after.x / before.x);
    }
    EXPECT_GT(largest, 1.1f);
    EXPECT_LE(largest, 1.0f + 1.0f / 3.0f) << "its share at a width of 2";
}

TEST_F(DrawnKind, ItsValues_AreThoseOfTheMaterial) {
    const Image black = capture(velvet(glm::dvec3(0.0)));
    EXPECT_EQ(black.pixels, capture(simpleScene()).pixels);
    EXPECT_NE(black.pixels, capture(velvet(glm::dvec3(0.5))).pixels);
}

TEST_F(DrawnKind, ReadFromAFile_DrawsTheSame) {
    Scene scene = velvet({0.25, 0.5, 1.0});
    const LocatedJson document{"a.patina.json", toJson(scene.objects[0].material, {}), {}};
    const auto reading = materialFromJson(document, "", *catalog);
    ASSERT_TRUE(reading);
    const Image before = capture(scene);
    scene.objects[0].material = reading->material;
    EXPECT_EQ(capture(scene).pixels, before.pixels);
}

TEST_F(DrawnKind, ItsRow_SwitchesItOff) {
    const Scene scene = velvet(glm::dvec3(1.0));
    const std::string effect = "sheen/velvet";
    const std::vector<EffectRow> rows = effectRows(scene, 0, *catalog);
    EXPECT_NE(std::ranges::find(rows, effect, [](const EffectRow& row) { return row.line.effect; }),
              rows.end());
    EXPECT_EQ(capture(withoutEffects(scene, {&effect, 1}, *catalog)).pixels,
              capture(simpleScene()).pixels);
}

} // namespace
} // namespace patina::tests::drawn_kind_test
