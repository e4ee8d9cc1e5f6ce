// SPDX-License-Identifier: GPL-3.0-or-later
// The effect that CONTRIBUTING.md shows, as it stands there: its two files and its row make it an
// effect like all others.
#include <array>

#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include "catalog/catalog.h"
#include "gl/headless_context.h"
#include "gl/shader.h"
#include "shading/effects/effect_key.h"
#include "shading/effects/effect_rows.h"
#include "shading/effects/surface_program.h"

namespace patina::tests::added_effect_test {
namespace {

const Catalog& catalog() {
    static const Catalog loaded =
        loadCatalog(std::array{BlockRoot{PATINA_SOURCE_DIR "/shaders", true}});
    return loaded;
}

/// An object of the first model, exposed so.
Scene sceneAt(double exposure) {
    Scene scene;
    scene.exposure = exposure;
    scene.objects.emplace_back().material =
        defaultMaterial(*catalog().ofKind(kinds::models).front());
    return scene;
}

const Scene day = sceneAt(0.0);
const Scene night = sceneAt(-6.0);

EffectRow rowOf(const Scene& scene) {
    const std::vector<EffectRow> rows = effectRows(scene, 0, catalog());
    const auto found = std::ranges::find(
        rows, "night", [](const EffectRow& row) { return std::string_view(row.line.effect); });
    EXPECT_NE(found, rows.end());
    return found == rows.end() ? EffectRow() : *found;
}

std::string fragmentOf(const Scene& scene) {
    const auto source =
        surfaceProgram(effectSet(scene.objects[0].material, scene, catalog()), catalog());
    EXPECT_TRUE(source) << (source ? "" : text(source.error()));
    return source ? source->fragment.text : std::string();
}

TEST(AddedEffect, CalledFor_IsInTheListAndInTheText) {
    EXPECT_TRUE(rowOf(night).in);
    EXPECT_EQ(rowOf(night).line.reason, "The exposure is below -4 stops.");
    EXPECT_NE(fragmentOf(night).find("shaded = atNight(shaded, sceneData[1].x)"),
              std::string::npos);
}

TEST(AddedEffect, NotCalledFor_IsInNoText) {
    EXPECT_FALSE(rowOf(day).in);
    EXPECT_EQ(rowOf(day).line.reason, "The exposure is not below -4 stops.");
    EXPECT_EQ(fragmentOf(day).find("Night"), std::string::npos);
}

TEST(AddedEffect, ItsChoice_IsInTheKey) {
    EffectKey keys;
    EXPECT_NE(keys.ofScene(day, catalog(), {}), keys.ofScene(night, catalog(), {}));
    EXPECT_EQ(keys.ofScene(day, catalog(), {}), keys.ofScene(sceneAt(2.0), catalog(), {}));
}

TEST(AddedEffect, ItsData_ArePackedByItsOwnFile) {
    const Scene dusk = sceneAt(-5.0);
    const EffectSet set = sceneEffects(dusk, catalog());
    const SceneLayout layout = sceneLayout(set);
    ASSERT_EQ(layout.own.size(), 1u);
    EXPECT_EQ(layout.firstLight, SceneLayout::fixed + 1);
    std::array<glm::vec4, 1> packed{};
    layout.own[0].pack(packed, dusk, set);
    EXPECT_EQ(packed[0].x, 0.5f);
}

TEST(AddedEffect, ThatSaysNothingOfDoublePrecision_HasNoFrameInIt) {
    EXPECT_EQ(unknownToReference(effectSet(night.objects[0].material, night, catalog())), "night");
    EXPECT_EQ(unknownToReference(effectSet(day.objects[0].material, day, catalog())), "");
}

TEST(AddedEffect, SwitchedOff_LeavesTheTextOfADay) {
    EXPECT_TRUE(rowOf(night).removable);
    const std::string effect = "night";
    EXPECT_EQ(fragmentOf(withoutEffects(night, {&effect, 1}, catalog())), fragmentOf(day));
}

TEST(AddedEffect, ItsText_IsCompiled) {
    const auto context = gl::HeadlessContext::create();
    ASSERT_TRUE(context) << context.error().text();
    const auto shader = gl::Shader::compile(GL_FRAGMENT_SHADER, fragmentOf(night));
    EXPECT_TRUE(shader) << shader.error();
}

} // namespace
} // namespace patina::tests::added_effect_test
