// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/effect_set.h"
#include "shading/effects/surface_program.h"
#include "shading/program/program_source.h"

#include <algorithm>
#include <cctype>
#include <regex>

#include "shading_scene.h"

namespace patina::program_source_test {
namespace {

std::string lower(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

/// An effect that a scene may call for, and the word that betrays it.
struct Effect {
    std::string name;
    std::regex word;
    void (*add)(Material& material, Scene& scene);
};

class EffectWordTest : public ShadingTest, public testing::WithParamInterface<Effect> {
  public:
    static BlockValues of(const std::string& kind, const std::string& id) {
        return block(kind, id);
    }
    static Light lightOf(const std::string& id) { return light(id); }

  protected:
    /// Every effect but the one under test.
    static void addOthers(Material& material, Scene& scene);
    static bool has(const std::string& source) {
        return std::regex_search(lower(source), GetParam().word);
    }
};

template <int index>
void addLight(Material&, Scene& scene) {
    constexpr std::array names{"directional", "point", "spot", "head"};
    scene.lights.push_back(EffectWordTest::lightOf(names[index]));
}

const std::vector<Effect>& effects() {
    static const std::vector<Effect> all{
        {"Fog", std::regex("fog"),
         [](Material&, Scene& scene) {
             scene.setPart(kinds::fog, EffectWordTest::of("fog", "exponential"));
         }},
        {"Fresnel", std::regex("fresnel"),
         [](Material& material, Scene&) {
             material.parts["fresnel"] = EffectWordTest::of("fresnel", "schlick");
         }},
        {"Opacity", std::regex("opacity"),
         [](Material& material, Scene&) { material.opacity = 0.5; }},
        {"Ambient", std::regex("ambient"),
         [](Material&, Scene& scene) { scene.ambient = glm::dvec3(0.1); }},
        {"Environment", std::regex("environment"),
         [](Material&, Scene& scene) {
             scene.setPart(kinds::environment, EffectWordTest::of("environment", "studio"));
         }},
        {"Directional", std::regex("directional"), addLight<0>},
        {"Point", std::regex("point(light|_light)|\\bpoint\\b"), addLight<1>},
        {"Spot", std::regex("spot"), addLight<2>},
        {"Head", std::regex("head"), addLight<3>},
    };
    return all;
}

void EffectWordTest::addOthers(Material& material, Scene& scene) {
    for (const Effect& effect : effects()) {
        if (effect.name != GetParam().name) {
            effect.add(material, scene);
        }
    }
}

TEST_P(EffectWordTest, NotInTheScene_NotInTheSource) {
    Material lambert = material("lambert");
    Scene scene;
    addOthers(lambert, scene);
    EXPECT_FALSE(has(fragment(lambert, scene)));
}

TEST_P(EffectWordTest, InTheScene_InTheSource) {
    Material lambert = material("lambert");
    Scene scene;
    GetParam().add(lambert, scene);
    EXPECT_TRUE(has(fragment(lambert, scene)));
}

INSTANTIATE_TEST_SUITE_P(Effects, EffectWordTest, testing::ValuesIn(effects()),
                         [](const auto& instance) { return instance.param.name; });

class ProgramSourceTest : public ShadingTest {};

TEST_F(ProgramSourceTest, NoLights_NoWordOfLight) {
    EXPECT_EQ(lower(fragment(material("lambert"), {})).find("light"), std::string::npos);
}

TEST_F(ProgramSourceTest, BlackHemisphere_NotInTheSource) {
    Scene scene;
    scene.ambient = glm::dvec3(0.1);
    EXPECT_EQ(lower(fragment(material("lambert"), scene)).find("hemisphere"), std::string::npos);
    scene.hemisphere.ground = glm::dvec3(0.0, 0.1, 0.0);
    EXPECT_NE(lower(fragment(material("lambert"), scene)).find("hemisphere"), std::string::npos);
}

TEST_F(ProgramSourceTest, AmbientOfAModelThatTurningDoesNotChange_AsksNoSurface) {
    Scene scene;
    scene.ambient = glm::dvec3(0.1);
    scene.hemisphere.sky = glm::dvec3(0.1);
    const std::string even = fragment(material("phong"), scene);
    EXPECT_NE(even.find("ambientShare(levelled(s), model)"), std::string::npos);
    EXPECT_EQ(even.find("ambientShare(s, model)"), std::string::npos);
    const std::string grained = fragment(material("ward"), scene);
    EXPECT_NE(grained.find("ambientShare(s, model)"), std::string::npos);
    EXPECT_EQ(grained.find("levelled"), std::string::npos);
}

TEST_F(ProgramSourceTest, EnvironmentWithoutAPicture_HasNoSamplerOfOne) {
    Scene scene;
    scene.setPart(kinds::environment, block("environment", "studio"));
    EXPECT_EQ(fragment(material("lambert"), scene).find("environmentImage"), std::string::npos);
    scene.setPart(kinds::environment, block("environment", "image"));
    scene.part(kinds::environment)->parameters["image"] = std::string("sky.hdr");
    EXPECT_NE(fragment(material("lambert"), scene).find("environmentImage"), std::string::npos);
}

TEST_F(ProgramSourceTest, EmptySlot_NoLobeInTheSource) {
    Scene scene;
    scene.lights = {light("point")};
    Material matte = material("lambert");
    EXPECT_EQ(lower(fragment(matte, scene)).find("lobe"), std::string::npos);
    matte.parts["specular"] = block("specular", "phong");
    EXPECT_NE(lower(fragment(matte, scene)).find("powerlobe"), std::string::npos);
}

TEST_F(ProgramSourceTest, Emission_IsAddedOnceForAllLights) {
    Scene scene;
    scene.lights = {light("point"), light("head")};
    Material glowing = material("lambert");
    EXPECT_EQ(fragment(glowing, scene).find("model.emissiveColor"), std::string::npos);
    glowing.model.parameters["emissive.color"] = glm::dvec3(0.1);
    const std::string source = fragment(glowing, scene);
    const std::size_t first = source.find("shaded += model.emissiveColor");
    ASSERT_NE(first, std::string::npos);
    EXPECT_EQ(source.find("model.emissiveColor", first + 30), std::string::npos);
}

TEST_F(ProgramSourceTest, AnotherLightInALoop_SameText) {
    Scene many;
    many.lights.assign(9, light("point"));
    Scene more = many;
    more.lights.push_back(light("point"));
    EXPECT_TRUE(fragment(material("phong"), many) == fragment(material("phong"), more));
}

TEST_F(ProgramSourceTest, FewLights_NoLoop) {
    Scene two;
    two.lights.assign(2, light("point"));
    EXPECT_EQ(fragment(material("phong"), two).find("for (int i = 0; i < int(sceneData"),
              std::string::npos);
}

TEST_F(ProgramSourceTest, OrderOfLights_DoesNotChangeTheText) {
    Scene scene;
    scene.lights = {light("point"), light("head"), light("spot")};
    const std::string before = fragment(material("phong"), scene);
    std::reverse(scene.lights.begin(), scene.lights.end());
    EXPECT_EQ(fragment(material("phong"), scene), before);
}

TEST_F(ProgramSourceTest, ChangedValue_SameHash) {
    Material phong = material("phong");
    const Scene scene;
    const auto before = surfaceProgram(effectSet(phong, scene, catalog()), catalog());
    phong.model.parameters["shininess"] = 7.0;
    const auto after = surfaceProgram(effectSet(phong, scene, catalog()), catalog());
    EXPECT_EQ(before->hash(), after->hash());
}

TEST_F(ProgramSourceTest, CompiledValue_IsADefine) {
    Material metal = material("cook-torrance");
    metal.model.parameters["distribution"] = std::string("ggx");
    const std::string define =
        "#define COMPILED_MODEL_DISTRIBUTION COOK_TORRANCE_DISTRIBUTION_GGX\n";
    EXPECT_NE(fragment(metal, {}).find(define), std::string::npos);
}

TEST_F(ProgramSourceTest, Comments_AreLeftOut) {
    EXPECT_EQ(fragment(material("phong"), {}).find("//"), std::string::npos);
}

TEST_F(ProgramSourceTest, MissingShaderFolder_IsAnErrorThatNamesTheFile) {
    Catalog moved = catalog();
    moved.roots = {{"/nowhere/shaders", true}};
    const auto program = surfaceProgram(effectSet(material("phong"), {}, moved), moved);
    ASSERT_FALSE(program);
    EXPECT_NE(text(program.error()).find("/nowhere/shaders/passes/surface.vert"),
              std::string::npos);
}

} // namespace
} // namespace patina::program_source_test
