// SPDX-License-Identifier: GPL-3.0-or-later
// What the effects say of a material's lines, and what is in their program.

#include "shading/effects/effect_key.h"
#include "shading/effects/effect_rows.h"
#include "shading/effects/effect_set.h"
#include "shading_scene.h"

namespace patina::outline_rows_test {
namespace {

class OutlineRows : public ShadingTest {
  protected:
    void SetUp() override {
        scene_.objects.resize(1);
        look() = material("lambert");
        look().parts["outline"] = block("outline", "ink-line");
    }

    Material& look() { return scene_.objects[0].material; }
    Value& value(const std::string& id) { return look().part("outline")->parameters[id]; }

    EffectRow row() const {
        for (const EffectRow& each : effectRows(scene_, 0, catalog())) {
            if (each.line.effect.starts_with("outline")) {
                return each;
            }
        }
        return {};
    }

    std::uint64_t key() { return EffectKey::ofMaterial(look(), catalog()); }

    ProgramSource program() {
        const auto made = outlineProgram(effectSet(look(), scene_, catalog()), catalog());
        EXPECT_TRUE(made) << (made ? "" : text(made.error()));
        return made ? *made : ProgramSource();
    }

    Scene scene_;
};

TEST_F(OutlineRows, OfAMaterialWithLines_AreIn) {
    EXPECT_EQ(row().line.effect, "outline/ink-line");
    EXPECT_TRUE(row().in);
    EXPECT_TRUE(row().removable);
}

TEST_F(OutlineRows, OfLinesWithoutAWidth_SayWhyTheyAreOut) {
    value("width") = 0.0;
    value("crease.width") = 0.0;
    EXPECT_FALSE(row().in);
    EXPECT_EQ(row().line.reason, "Its lines are 0 pixels wide.");
}

TEST_F(OutlineRows, OfAMaterialWithoutLines_SayThatItHasNone) {
    look().parts.clear();
    EXPECT_FALSE(row().in);
    EXPECT_EQ(row().line.reason, "The material has no outline.");
}

TEST_F(OutlineRows, OfAnUnknownKind_SaySo) {
    look().part("outline")->id = "brush";
    EXPECT_FALSE(row().in);
    EXPECT_EQ(row().line.reason, "No outline of this kind is known.");
}

TEST_F(OutlineRows, SwitchedOff_LeaveTheMaterialWithoutLines) {
    const std::string effect = row().line.effect;
    scene_ = withoutEffects(scene_, {&effect, 1}, catalog());
    EXPECT_EQ(look().part("outline"), nullptr);
}

TEST_F(OutlineRows, Key_ChangesWhereAWidthBecomesNothing) {
    const std::uint64_t both = key();
    value("width") = 5.0;
    EXPECT_EQ(key(), both);
    value("width") = 0.0;
    const std::uint64_t creases = key();
    EXPECT_NE(creases, both);
    value("crease.width") = 0.0;
    EXPECT_NE(key(), creases);
    EXPECT_NE(key(), both);
}

TEST_F(OutlineRows, KeyWithoutAWidth_IsThatOfNoLines) {
    value("width") = 0.0;
    value("crease.width") = 0.0;
    const std::uint64_t none = key();
    look().parts.clear();
    EXPECT_EQ(key(), none);
}

TEST_F(OutlineRows, SurfacesProgram_KnowsNothingOfLines) {
    const std::string lined = fragment(look(), scene_);
    look().parts.clear();
    EXPECT_EQ(fragment(look(), scene_), lined);
}

TEST_F(OutlineRows, Program_HasFogOnlyInAFoggyScene) {
    EXPECT_EQ(program().fragment.text.find("fog"), std::string::npos);
    EXPECT_EQ(program().fragment.text.find("sceneData"), std::string::npos);
    scene_.setPart(kinds::fog, block("fog", "exponential"));
    EXPECT_NE(program().fragment.text.find("foggedLine"), std::string::npos);
}

TEST_F(OutlineRows, Program_HasNoLights) {
    const std::string without = program().fragment.text;
    scene_.lights.push_back(light("point"));
    EXPECT_EQ(program().fragment.text, without);
}

} // namespace
} // namespace patina::outline_rows_test
