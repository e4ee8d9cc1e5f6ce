// SPDX-License-Identifier: GPL-3.0-or-later
// What the command line chooses and sets in a scene, by the names that files have.
#include <algorithm>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "catalog/settings.h"
#include "cli/patina_program.h"
#include "cli/picture_options.h"
#include "cli/scene_setup.h"
#include "scene/scene_settings.h"

namespace patina::tests::scene_options_test {
namespace {

const Catalog& catalog() {
    static const Catalog loaded = loadCatalog(standardBlockRoots());
    return loaded;
}

/// The shipped scene of three lights with these options.
Checked<SceneSetup> setupWith(const std::vector<std::string>& arguments) {
    CLI::App program;
    PictureOptions options;
    addSceneOptions(program, options);
    program.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
    options.scene = options.scene.empty()
                        ? shipped("presets/three-lights.patina-scene.json").string()
                        : options.scene;
    return sceneFor({}, options, catalog());
}

Scene sceneWith(const std::vector<std::string>& arguments) {
    const auto setup = setupWith(arguments);
    EXPECT_TRUE(setup) << text(setup.error());
    return setup ? setup->scene : Scene();
}

std::string errorWith(const std::vector<std::string>& arguments) {
    const auto setup = setupWith(arguments);
    EXPECT_FALSE(setup);
    return setup ? std::string() : text(setup.error());
}

TEST(SceneOptions, Fog_IsChosenAndSet) {
    const Scene scene = sceneWith({"--fog", "linear", "--set", "fog.end=25"});
    ASSERT_NE(scene.part(kinds::fog), nullptr);
    EXPECT_EQ(scene.part(kinds::fog)->parameters.at("end"), Value(25.0));
}

TEST(SceneOptions, Passes_AreChosenInARowAndSet) {
    const Scene scene = sceneWith({"--pass", "kuwahara,kuwahara", "--set", "pass.radius=3", "--set",
                                   "pass.2.radius=5", "--set", "pass.kuwahara.stretch=0"});
    ASSERT_EQ(scene.passes.size(), 2u);
    EXPECT_EQ(scene.passes[0].parameters.at("radius"), Value(3.0));
    EXPECT_EQ(scene.passes[1].parameters.at("radius"), Value(5.0));
    EXPECT_EQ(scene.passes[0].parameters.at("stretch"), Value(0.0));
    EXPECT_TRUE(sceneWith({"--pass", "none"}).passes.empty());
}

TEST(SceneOptions, PassThatIsNotThere_IsToldByName) {
    EXPECT_NE(errorWith({"--set", "pass.radius=3"}).find("no picture pass"), std::string::npos);
    EXPECT_NE(errorWith({"--pass", "kuwahara", "--set", "pass.colour=3"}).find("kuwahara"),
              std::string::npos);
    EXPECT_NE(errorWith({"--pass", "cubist"}).find("cubist"), std::string::npos);
}

TEST(SceneOptions, None_TakesAPartOut) {
    EXPECT_EQ(sceneWith({"--fog", "none"}).part(kinds::fog), nullptr);
}

TEST(SceneOptions, FormerNamesOfFogs_MeanThoseOfNow) {
    EXPECT_EQ(sceneWith({"--fog", "boxed"}).part(kinds::fog)->id, "box");
    EXPECT_EQ(sceneWith({"--fog", "low-lying"}).part(kinds::fog)->id, "height");
}

TEST(SceneOptions, ALightsId_StandsForAllLights) {
    const Scene scene = sceneWith({"--light", "point"});
    ASSERT_EQ(scene.lights.size(), 1u);
    EXPECT_EQ(scene.lights.front().block.id, "point");
}

TEST(SceneOptions, ANamedLight_GetsAnotherKindAlone) {
    const Scene before = sceneWith({});
    const Scene scene = sceneWith({"--light", "key=spot", "--light", "lamp=point"});
    ASSERT_EQ(scene.lights.size(), before.lights.size() + 1);
    EXPECT_EQ(scene.lights[0].block.id, "spot");
    EXPECT_EQ(scene.lights[1], before.lights[1]);
    EXPECT_EQ(scene.lights.back().name, "lamp");
}

TEST(SceneOptions, ALightsValue_IsSetByItsName) {
    const Scene scene = sceneWith({"--set", "light.key.intensity=2"});
    EXPECT_EQ(scene.lights[0].block.parameters.at("intensity"), Value(2.0));
}

TEST(SceneOptions, ALight_IsSwitchedOffByItsName) {
    const Scene scene = sceneWith({"--set", "light.key.enabled=false"});
    EXPECT_FALSE(scene.lights[0].enabled);
    EXPECT_TRUE(scene.lights[1].enabled);
    EXPECT_EQ(scene.lights[0].block, sceneWith({}).lights[0].block);
}

TEST(SceneOptions, ALightThatIsNeitherOnNorOff_IsAnError) {
    const std::string error = errorWith({"--set", "light.key.enabled=dim"});
    EXPECT_NE(error.find("enabled: \"dim\" is not a value for it"), std::string::npos) << error;
}

TEST(SceneOptions, AShadow_IsChosenAndSet) {
    const Scene scene =
        sceneWith({"--shadow", "key=filtered", "--set", "light.key.shadow.width=0.25"});
    ASSERT_TRUE(scene.lights[0].part(kinds::shadows));
    EXPECT_EQ(scene.lights[0].part(kinds::shadows)->parameters.at("width"), Value(0.25));
    EXPECT_EQ(scene.lights[1].parts, sceneWith({}).lights[1].parts);
}

TEST(SceneOptions, AShadowsValueWithoutALight_IsSetInAllThatHaveAShadow) {
    const Scene scene = sceneWith(
        {"--shadow", "key=filtered", "--shadow", "fill=filtered", "--set", "shadow.width=0.25"});
    EXPECT_EQ(scene.lights[0].part(kinds::shadows)->parameters.at("width"), Value(0.25));
    EXPECT_EQ(scene.lights[1].part(kinds::shadows)->parameters.at("width"), Value(0.25));
    EXPECT_EQ(scene.lights[2].part(kinds::shadows), nullptr);
}

TEST(SceneOptions, AShadowsValueWithoutAShadow_NamesTheOption) {
    const std::string error = errorWith({"--shadow", "none", "--set", "shadow.width=0.25"});
    EXPECT_NE(error.find("no light has a shadow"), std::string::npos) << error;
    EXPECT_NE(error.find("--shadow"), std::string::npos) << error;
}

TEST(SceneOptions, SettingsOfTheScene_AreSet) {
    const Scene scene = sceneWith({"--set", "scene.exposure=1", "--set", "ground.mode=plane",
                                   "--set", "camera.yaw=90", "--set", "object.visible=false"});
    EXPECT_EQ(scene.exposure, 1.0);
    EXPECT_EQ(scene.ground.mode, GroundMode::Plane);
    EXPECT_EQ(scene.camera.yaw, 90.0);
    EXPECT_FALSE(scene.objects.front().visible);
}

TEST(SceneOptions, EverySetting_IsSet) {
    for (const std::string_view word : {settings::scene, settings::camera, settings::object}) {
        for (const Parameter& parameter : settingsBlock(word)->parameters) {
            const std::string id = std::string(word) + '.' + parameter.id;
            const bool isChoice = parameter.type == ParameterType::Enum;
            const bool isFlag = parameter.type == ParameterType::Bool;
            const bool isTriple = componentCount(parameter.type) == 3;
            const std::string number = fmt::format("{}", std::max(1.0, parameter.min));
            const std::string value = isChoice   ? parameter.values.front().id
                                      : isFlag   ? "true"
                                      : isTriple ? fmt::format("{0},{0},{0}", number)
                                                 : number;
            EXPECT_TRUE(setupWith({"--set", id + '=' + value})) << id;
        }
    }
}

TEST(SceneOptions, LightsWithoutANameAmongOthers_StandInPlaceOfTheScenes) {
    const Scene scene = sceneWith({"--light", "key=point", "--light", "spot"});
    ASSERT_EQ(scene.lights.size(), 2u);
    EXPECT_EQ(scene.lights[0].name, "key");
    EXPECT_EQ(scene.lights[1].block.id, "spot");
    EXPECT_TRUE(sceneWith({"--light", "point", "--light", "none"}).lights.empty());
}

TEST(SceneOptions, NamesOfNoLight_AreErrorsWithThoseThereAre) {
    EXPECT_NE(errorWith({"--light", "kye=none"}).find("'key'"), std::string::npos);
    EXPECT_NE(errorWith({"--shadow", "kye=hard"}).find("'key'"), std::string::npos);
    EXPECT_NE(errorWith({"--light", "=point"}).find("before the ="), std::string::npos);
    EXPECT_NE(errorWith({"--shadow", "=hard"}).find("before the ="), std::string::npos);
}

TEST(SceneOptions, ErrorsOfAnAssignment_RepeatWhatWasTyped) {
    for (const char* wrong : {"fog.density=1", "light.key.intensit=2", "light.key=2",
                              "camera.yaw=abc", "fog=linear", "picture.nothing=1", "fresnel.f=0"}) {
        EXPECT_NE(errorWith({"--set", wrong}).find(std::string("--set ") + wrong + ": "),
                  std::string::npos)
            << errorWith({"--set", wrong});
    }
    EXPECT_NE(errorWith({"--set", "fog=linear"}).find("--fog linear"), std::string::npos);
    EXPECT_NE(errorWith({"--set", "light.key=2"}).find("is no value"), std::string::npos);
}

TEST(SceneOptions, Misspelt_AreErrorsWithTheNearestName) {
    EXPECT_NE(errorWith({"--fog", "linaer"}).find("'linear'"), std::string::npos);
    EXPECT_NE(errorWith({"--light", "pont"}).find("'point'"), std::string::npos);
    EXPECT_NE(errorWith({"--set", "scene.exposur=1"}).find("'exposure'"), std::string::npos);
    EXPECT_NE(errorWith({"--set", "light.kye.intensity=1"}).find("'key'"), std::string::npos);
    EXPECT_NE(errorWith({"--set", "light.key.intensty=1"}).find("'intensity'"), std::string::npos);
    EXPECT_NE(errorWith({"--fog", "linear", "--set", "fog.strat=1"}).find("'start'"),
              std::string::npos);
    EXPECT_NE(errorWith({"--set", "opacty=1"}).find("'opacity'"), std::string::npos);
}

TEST(SceneOptions, AValueOfWhatIsNotThere_NamesTheOption) {
    const std::string error = errorWith({"--fog", "none", "--set", "fog.density=1"});
    EXPECT_NE(error.find("--fog"), std::string::npos) << error;
}

} // namespace
} // namespace patina::tests::scene_options_test
