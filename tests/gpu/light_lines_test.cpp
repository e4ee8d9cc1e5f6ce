// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/light_lines.h"

#include "shading/effects/effect_key.h"
#include "shading/effects/effect_set.h"
#include "shading_scene.h"

namespace patina::light_lines_test {
namespace {

class LightLinesTest : public ShadingTest {
  protected:
    static Scene sceneOf(const char* kind, int count) {
        Scene scene;
        for (int i = 0; i < count; ++i) {
            scene.lights.push_back(light(kind));
        }
        return scene;
    }

    static int linesOf(const Scene& scene) {
        return sceneEffects(scene, catalog()).lights.front().lines;
    }

    static std::uint64_t keyOf(const Scene& scene) {
        return EffectKey().ofScene(scene, catalog());
    }
};

TEST_F(LightLinesTest, FewLights_HaveALineEach) {
    EXPECT_EQ(linesOf(sceneOf("directional", 1)), 1);
    EXPECT_EQ(linesOf(sceneOf("point", 4)), 4);
}

TEST_F(LightLinesTest, ManyLights_AreALoop) {
    EXPECT_EQ(linesOf(sceneOf("point", 5)), 0);
}

TEST_F(LightLinesTest, FewOfManyLights_AreALoop) {
    Scene scene = sceneOf("directional", 2);
    for (int i = 0; i < 7; ++i) {
        scene.lights.push_back(light("point"));
    }
    EXPECT_EQ(linesOf(scene), 0);
}

TEST_F(LightLinesTest, LightWithAnEnd_IsALoop) {
    Scene ranged = sceneOf("point", 1);
    ranged.lights[0].block.parameters["range"] = 2.0;
    EXPECT_EQ(linesOf(ranged), 0);
    EXPECT_EQ(linesOf(sceneOf("spot", 1)), 0);
}

TEST_F(LightLinesTest, AnotherLine_IsAnotherKey) {
    EXPECT_NE(keyOf(sceneOf("point", 1)), keyOf(sceneOf("point", 2)));
}

TEST_F(LightLinesTest, LongerLoop_HasTheSameKey) {
    EXPECT_EQ(keyOf(sceneOf("point", 9)), keyOf(sceneOf("point", 10)));
}

TEST_F(LightLinesTest, LightThatIsOff_ChangesNoKey) {
    Scene scene = sceneOf("point", 2);
    const std::uint64_t both = keyOf(scene);
    scene.lights.push_back(light("point"));
    scene.lights.back().enabled = false;
    EXPECT_EQ(keyOf(scene), both);
}

} // namespace
} // namespace patina::light_lines_test
