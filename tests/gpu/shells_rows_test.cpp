// SPDX-License-Identifier: GPL-3.0-or-later
// What the effects say of a material's strands, and what is in its program.

#include "shading/effects/effect_key.h"
#include "shading/effects/effect_rows.h"
#include "shading/effects/shells.h"
#include "shading_scene.h"

namespace patina::shells_rows_test {
namespace {

class ShellsRows : public ShadingTest {
  protected:
    void SetUp() override {
        scene_.objects.resize(1);
        scene_.lights.push_back(light("directional"));
        look() = material("lambert");
        look().parts["shells"] = block("shells", "fur");
    }

    Material& look() { return scene_.objects[0].material; }
    Value& value(const std::string& id) { return look().part("shells")->parameters[id]; }

    EffectRow row() const {
        for (const EffectRow& each : effectRows(scene_, 0, catalog())) {
            if (each.line.effect.starts_with("shells")) {
                return each;
            }
        }
        return {};
    }

    std::string vertex(SurfaceOutput output = SurfaceOutput::Picture) {
        const auto made = surfaceProgram(effectSet(look(), scene_, catalog()), catalog(), output);
        EXPECT_TRUE(made) << (made ? "" : text(made.error()));
        return made ? made->vertex.text : std::string();
    }

    Scene scene_;
};

TEST_F(ShellsRows, OfAFurryMaterial_AreIn) {
    EXPECT_EQ(row().line.effect, "shells/fur");
    EXPECT_TRUE(row().in);
    EXPECT_TRUE(row().removable);
}

TEST_F(ShellsRows, OfStrandsWithoutALength_SayWhyTheyAreOut) {
    value("strand.length") = 0.0;
    EXPECT_FALSE(row().in);
    EXPECT_EQ(row().line.reason, "Its strands are 0 metres long.");
}

TEST_F(ShellsRows, OfStrandsWithoutADensity_SayWhyTheyAreOut) {
    value("density") = 0.0;
    EXPECT_FALSE(row().in);
    EXPECT_EQ(row().line.reason, "Its density is 0: no strand grows.");
}

TEST_F(ShellsRows, OfATransparentMaterial_SayWhyTheyAreOut) {
    look().opacity = 0.5;
    EXPECT_FALSE(row().in);
    EXPECT_EQ(row().line.reason, "The material is transparent: strands grow on solid ones.");
}

TEST_F(ShellsRows, OfAPlainMaterial_SayThatNothingGrows) {
    look().parts.clear();
    EXPECT_FALSE(row().in);
    EXPECT_EQ(row().line.reason, "Nothing grows on the material.");
}

TEST_F(ShellsRows, CombedByAnImage_HaveItInTheirVerticesAlone) {
    const std::string uncombed = vertex();
    EXPECT_EQ(uncombed.find("combed"), std::string::npos);
    TextureUse& comb = look().textures["shells.comb.direction"];
    comb = textureUse("shells.comb.direction", "/whorls.png");
    EXPECT_NE(vertex().find("combedTowards"), std::string::npos);
    const std::string combed = fragment(look(), scene_);
    EXPECT_EQ(combed.find("combedTowards"), std::string::npos);
    EXPECT_EQ(combed.substr(combed.find("void main()")).find("combDirection"), std::string::npos);
    comb.strength = 0.0;
    EXPECT_EQ(vertex(), uncombed);
}

TEST_F(ShellsRows, OfStrandsThatAreOut_LeaveNothingInTheProgram) {
    value("strand.length") = 0.0;
    const std::string out = fragment(look(), scene_);
    const std::string outVertex = vertex();
    look().parts.clear();
    EXPECT_EQ(out, fragment(look(), scene_));
    EXPECT_EQ(outVertex, vertex());
    EXPECT_EQ(out.find("strand"), std::string::npos);
}

TEST_F(ShellsRows, LightOfTheModel_LeavesTheStrandsOwnOut) {
    EXPECT_EQ(fragment(look(), scene_).find("strandShininess)"), std::string::npos);
    value("lighting") = std::string("strand");
    EXPECT_NE(fragment(look(), scene_).find("strandShininess)"), std::string::npos);
}

TEST_F(ShellsRows, OutputsOfTheSurface_HaveNoLayers) {
    EXPECT_NE(vertex().find("gl_InstanceID"), std::string::npos);
    EXPECT_EQ(vertex(SurfaceOutput::Inspection).find("gl_InstanceID"), std::string::npos);
    EXPECT_EQ(vertex(SurfaceOutput::Buffer).find("gl_InstanceID"), std::string::npos);
}

TEST_F(ShellsRows, Layers_AreThoseOfTheChosenLevel) {
    EXPECT_EQ(instancesOf(effectSet(look(), scene_, catalog())), 65);
    look().accuracy["layers"] = "8";
    EXPECT_EQ(instancesOf(effectSet(look(), scene_, catalog())), 9);
    look().parts.clear();
    EXPECT_EQ(instancesOf(effectSet(look(), scene_, catalog())), 1);
}

TEST_F(ShellsRows, SwitchedOff_LeaveTheMaterial) {
    const std::string effect = "shells/fur";
    scene_ = withoutEffects(scene_, {&effect, 1}, catalog());
    EXPECT_EQ(look().part("shells"), nullptr);
}

} // namespace
} // namespace patina::shells_rows_test
