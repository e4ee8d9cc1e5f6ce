// SPDX-License-Identifier: GPL-3.0-or-later
// Why shadows and the ground are in or out.
#include "shading/effects/effect_rows.h"

#include "shading/effects/effect_key.h"
#include "shading_scene.h"

namespace patina::shadow_rows_test {
namespace {

/// Two objects on a plane in a sun with shadows.
class ShadowRowsTest : public ShadingTest {
  protected:
    ShadowRowsTest() {
        scene_.objects.resize(2);
        for (Object& object : scene_.objects) {
            object.material = material("lambert");
        }
        scene_.lights = {light("directional")};
        scene_.lights[0].name = "Key";
        scene_.lights[0].setPart(kinds::shadows, block("shadows", "hard"));
        scene_.ground.mode = GroundMode::Plane;
    }

    EffectRow row(const std::string& effect, std::size_t object = 0) const {
        for (const EffectRow& each : effectRows(scene_, object, catalog())) {
            if (each.line.effect == effect) {
                return each;
            }
        }
        return {};
    }

    std::string whyOut(const std::string& effect) const {
        const EffectRow found = row(effect);
        EXPECT_FALSE(found.in) << effect;
        return found.line.reason;
    }

    Scene scene_;
};

TEST_F(ShadowRowsTest, Shadows_SayHowManyCastThemAndWhichLightsHaveThem) {
    EXPECT_EQ(row("shadows/hard").line.reason, "2 objects cast shadows. Key has them.");
    scene_.objects[1].castsShadow = false;
    scene_.lights.push_back(light("point"));
    scene_.lights[1].name = "Lamp";
    scene_.lights[1].parts = scene_.lights[0].parts;
    EXPECT_EQ(row("shadows/hard").line.reason,
              "One object casts a shadow. Key and Lamp have them.");
}

TEST_F(ShadowRowsTest, ShadowsWithoutCaster_SayWhatKeepsEachObjectFromIt) {
    scene_.objects.push_back(scene_.objects[0]);
    scene_.objects[0].visible = false;
    scene_.objects[1].castsShadow = false;
    scene_.objects[2].material.opacity = 0.3;
    EXPECT_EQ(whyOut("shadows of Key"),
              "No object casts a shadow: 1 is hidden, 1 is set to cast none, 1 is more than half "
              "transparent.");
}

TEST_F(ShadowRowsTest, ShadowsWithoutReceiver_AreOut) {
    scene_.ground.mode = GroundMode::Off;
    for (Object& object : scene_.objects) {
        object.material.model.id = "unheard-of";
    }
    EXPECT_TRUE(whyOut("shadows of Key").starts_with("No shadow falls on anything:"))
        << whyOut("shadows of Key");
}

TEST_F(ShadowRowsTest, OneShadowReceiver_IsEnough) {
    for (Object& object : scene_.objects) {
        object.material.model.id = "unheard-of";
    }
    EXPECT_TRUE(groundEffects(scene_, catalog()).lights[0].shadow) << "the ground";
    scene_.ground.mode = GroundMode::Off;
    scene_.objects[1].material = material("lambert");
    EXPECT_TRUE(row("shadows/hard", 1).in) << "the second object";
}

TEST_F(ShadowRowsTest, Key_KnowsWhetherAnythingReceivesShadows) {
    for (Object& object : scene_.objects) {
        object.material.model.id = "unheard-of";
    }
    EffectKey keys;
    const std::uint64_t before = keys.ofScene(scene_, catalog());
    scene_.ground.mode = GroundMode::Off;
    EXPECT_NE(keys.ofScene(scene_, catalog()), before);
    EXPECT_FALSE(sceneEffects(scene_, catalog()).lights[0].shadow);
}

TEST_F(ShadowRowsTest, ShadowsOfOtherObjects_AreThereForOneThatCastsNone) {
    scene_.objects[0].castsShadow = false;
    EXPECT_TRUE(row("shadows/hard").in);
    EXPECT_TRUE(row("shadows/hard").removable);
}

TEST_F(ShadowRowsTest, LightThatCastsNone_IsNamed) {
    scene_.lights[0].block = block("lights", "head");
    scene_.lights[0].part(kinds::shadows)->id = "unheard-of";
    EXPECT_EQ(row("shadows of Key").line.reason, "No kind of shadow \"unheard-of\" is known.");
}

TEST_F(ShadowRowsTest, NoLightWithShadows_IsSaidOnce) {
    scene_.lights[0].setPart(kinds::shadows, std::nullopt);
    EXPECT_EQ(whyOut("shadows"), "No light has shadows.");
}

TEST_F(ShadowRowsTest, SwitchedOffShadows_LeaveTheLight) {
    const std::vector<std::string> off{"shadows/hard"};
    const Scene without = withoutEffects(scene_, off, catalog());
    const EffectSet effects = sceneEffects(without, catalog());
    ASSERT_EQ(effects.lights.size(), 1u);
    EXPECT_FALSE(effects.lights[0].shadow);
}

TEST_F(ShadowRowsTest, SwitchedOffShadowsOfAnotherKind_ChangeNothing) {
    const std::vector<std::string> off{"shadows/soft"};
    EXPECT_EQ(withoutEffects(scene_, off, catalog()), scene_);
}

TEST_F(ShadowRowsTest, Ground_SaysHowItIsDrawn) {
    scene_.ground.opacity = 0.75;
    EXPECT_EQ(row("ground").line.reason, "A matt plane that the lights shine on, opacity 0.75.");
    scene_.ground.mode = GroundMode::Shadows;
    EXPECT_EQ(row("ground").line.reason, "It shows the shadows that fall on it, opacity 0.75.");
}

TEST_F(ShadowRowsTest, GroundThatIsNotSeen_SaysWhy) {
    scene_.ground.mode = GroundMode::Off;
    EXPECT_EQ(whyOut("ground"), "The scene has no ground.");
    scene_.ground.mode = GroundMode::Plane;
    scene_.ground.opacity = 0.0;
    EXPECT_EQ(whyOut("ground"), "Its opacity is 0.");
    scene_.ground = Ground{GroundMode::Shadows};
    scene_.lights[0].setPart(kinds::shadows, std::nullopt);
    EXPECT_EQ(whyOut("ground"), "It shows shadows only, and no light has any.");
}

TEST_F(ShadowRowsTest, GroundOfShadows_IsWithinThem) {
    scene_.ground.mode = GroundMode::Shadows;
    EXPECT_EQ(row("ground").within, "shadows/hard");
    EXPECT_EQ(row("shadows/hard").within, "lights/directional");
}

TEST_F(ShadowRowsTest, SwitchedOffGround_IsGone) {
    const std::vector<std::string> off{"ground"};
    EXPECT_EQ(groundEffects(withoutEffects(scene_, off, catalog()), catalog()).ground,
              GroundMode::Off);
}

} // namespace
} // namespace patina::shadow_rows_test
