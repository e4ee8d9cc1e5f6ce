// SPDX-License-Identifier: GPL-3.0-or-later
// What the effects say of a material's marks, and what is in its programs.

#include "shading/effects/effect_rows.h"
#include "shading/effects/strokes.h"
#include "shading_scene.h"

namespace patina::strokes_rows_test {
namespace {

class StrokesRows : public ShadingTest {
  protected:
    void SetUp() override {
        scene_.objects.resize(1);
        scene_.lights.push_back(light("directional"));
        look() = material("lambert");
        look().parts["strokes"] = block("strokes", "stipple");
    }

    Material& look() { return scene_.objects[0].material; }
    Value& value(const std::string& id) { return look().part("strokes")->parameters[id]; }

    EffectRow row() const {
        for (const EffectRow& each : effectRows(scene_, 0, catalog())) {
            if (each.line.effect.starts_with("strokes")) {
                return each;
            }
        }
        return {};
    }

    ProgramSource marks() {
        const auto made = marksProgram(effectSet(look(), scene_, catalog()), catalog());
        EXPECT_TRUE(made) << (made ? "" : text(made.error()));
        return made ? *made : ProgramSource();
    }

    Scene scene_;
};

TEST_F(StrokesRows, OfAStippledMaterial_AreIn) {
    EXPECT_EQ(row().line.effect, "strokes/stipple");
    EXPECT_TRUE(row().in);
    EXPECT_TRUE(row().removable);
}

TEST_F(StrokesRows, OfMarksWithoutADensity_SayWhyTheyAreOut) {
    value("density") = 0.0;
    EXPECT_FALSE(row().in);
    EXPECT_EQ(row().line.reason, "Its density is 0: there are no marks.");
}

TEST_F(StrokesRows, OfMarksWithoutAWidth_SayWhyTheyAreOut) {
    value("dot.width") = 0.0;
    EXPECT_FALSE(row().in);
    EXPECT_EQ(row().line.reason, "Its marks are 0 pixels long or wide.");
}

TEST_F(StrokesRows, OfATransparentMaterial_SayWhyTheyAreOut) {
    look().opacity = 0.5;
    EXPECT_EQ(row().line.reason, "The material is transparent: marks are set on solid ones.");
}

TEST_F(StrokesRows, UnderFur_SayWhyTheyAreOut) {
    look().parts["shells"] = block("shells", "fur");
    EXPECT_EQ(row().line.reason, "Fur or grass grows over the surface and would hide them.");
}

TEST_F(StrokesRows, OfAPlainMaterial_SayThatThereAreNone) {
    look().parts.clear();
    EXPECT_FALSE(row().in);
    EXPECT_EQ(row().line.reason, "The material has no strokes.");
}

TEST_F(StrokesRows, OfMoreMarksThanAreDrawn_SaySo) {
    value("density") = 10000.0;
    value("dot.length") = 1000.0;
    EXPECT_NE(row().line.reason.find("no more of them than 32 over a pixel"), std::string::npos);
    value("dot.width") = 1000.0;
    EXPECT_DOUBLE_EQ(marksPerUnit(look(), catalog()), 32.0 / 1e6);
}

TEST_F(StrokesRows, OfMarksThatAreOut_LeaveNothingInTheProgram) {
    value("density") = 0.0;
    const std::string out = fragment(look(), scene_);
    look().parts.clear();
    EXPECT_EQ(out, fragment(look(), scene_));
    EXPECT_EQ(out.find("trokes"), std::string::npos);
    EXPECT_EQ(out.find("mark"), std::string::npos);
}

TEST_F(StrokesRows, Marks_AreLitByTheModel) {
    EXPECT_NE(marks().fragment.text.find("lambert("), std::string::npos);
}

TEST_F(StrokesRows, Level_IsTheShareOfMarks) {
    EXPECT_NE(marks().vertex.text.find("MARK_SHARE 1.00"), std::string::npos);
    const double all = marksPerUnit(look(), catalog());
    look().accuracy["marks"] = "25";
    EXPECT_NE(marks().vertex.text.find("MARK_SHARE 0.25"), std::string::npos);
    EXPECT_DOUBLE_EQ(marksPerUnit(look(), catalog()), 0.25 * all);
}

TEST_F(StrokesRows, SwitchedOff_LeaveTheMaterial) {
    const std::string effect = "strokes/stipple";
    scene_ = withoutEffects(scene_, {&effect, 1}, catalog());
    EXPECT_EQ(look().part("strokes"), nullptr);
}

} // namespace
} // namespace patina::strokes_rows_test
