// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/scene_file.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "catalog_fixture.h"
#include "scene/mesh_path.h"
#include "schema_check.h"

namespace patina::scene_file_test {
namespace {

using nlohmann::json;
using tests::BlockFolder;
using tests::plainDescriptor;

json panoramaDescriptor() {
    json descriptor = plainDescriptor("panorama");
    descriptor["parameters"].push_back(
        {{"id", "picture"}, {"label", "Picture"}, {"type", "texture"}, {"default", ""}});
    return descriptor;
}

const Catalog& sceneCatalog() {
    static const Catalog made = [] {
        BlockFolder folder;
        folder.add("models", plainDescriptor("velvet"));
        folder.add("lights", plainDescriptor("lamp"));
        json mist = plainDescriptor("mist");
        mist["formerIds"] = {"haze"};
        folder.add("fog", mist);
        folder.add("shadows", plainDescriptor("veil"));
        folder.add("environment", panoramaDescriptor());
        folder.add("transparency", plainDescriptor("glass"));
        folder.add("pass", plainDescriptor("brush"));
        return folder.load();
    }();
    return made;
}

json preset() {
    return {{"format", "patina.preset"},
            {"version", 1},
            {"name", "Inline"},
            {"model", {{"id", "velvet"}, {"version", 1}}},
            {"parameters", {{"gloss", 0.75}}}};
}

class SceneFile : public testing::Test {
  protected:
    static json plainScene() {
        return {{"format", "patina.scene"},
                {"version", 1},
                {"objects", {{{"name", "Ball"}, {"mesh", "builtin:sphere"}, {"preset", preset()}}}},
                {"lights", {{{"id", "lamp"}, {"parameters", {{"gloss", 0.25}}}}}},
                {"fog", {{"id", "mist"}, {"parameters", {{"gloss", 0.125}}}}},
                {"environment", {{"id", "panorama"}, {"parameters", {{"picture", "sky.hdr"}}}}}};
    }

    Checked<SceneReading> read(const json& scene) {
        tests::writeFile(file_, writeJson(scene));
        return readScene(file_, sceneCatalog());
    }

    Checked<SceneReading> readChanged(const json& changes) {
        json scene = plainScene();
        scene.merge_patch(changes);
        return read(scene);
    }

    Checked<SceneReading> readObject(const json& changes) {
        json scene = plainScene();
        scene["objects"][0].merge_patch(changes);
        return read(scene);
    }

    tests::TemporaryFolder folder_;
    std::filesystem::path file_ = folder_ / "a.patina-scene.json";
};

TEST_F(SceneFile, PlainScene_HasNoNotes) {
    const auto reading = read(plainScene());
    ASSERT_TRUE(reading) << text(reading.error());
    EXPECT_EQ(text(reading->notes), "");
}

TEST_F(SceneFile, InlinePreset_IsTheObjectsMaterial) {
    EXPECT_EQ(read(plainScene())->scene.objects[0].material.name, "Inline");
}

TEST_F(SceneFile, PresetFile_IsTheObjectsMaterial) {
    json named = preset();
    named["name"] = "From a file";
    tests::writeFile(folder_ / "p/x.patina.json", writeJson(named));
    EXPECT_EQ(readObject({{"preset", "p/x.patina.json"}})->scene.objects[0].material.name,
              "From a file");
}

/// Some eleven megabytes, as an artist's own scene of so many objects has.
TEST_F(SceneFile, ObjectsAlone_AreAReadableScene) {
    const auto whole = read(plainScene());
    const std::span<const Object> objects(whole->scene.objects);
    const auto copied = sceneFromJson({{}, sceneJsonOf(objects), {}}, sceneCatalog());
    ASSERT_TRUE(copied) << text(copied.error());
    EXPECT_EQ(copied->scene.objects, whole->scene.objects);
    EXPECT_TRUE(copied->scene.lights.empty());
}

TEST_F(SceneFile, LightsAlone_AreAReadableScene) {
    const auto whole = read(plainScene());
    const std::span<const Light> lights(whole->scene.lights);
    const auto copied = sceneFromJson({{}, sceneJsonOf(lights), {}}, sceneCatalog());
    ASSERT_TRUE(copied) << text(copied.error());
    EXPECT_EQ(copied->scene.lights, whole->scene.lights);
    EXPECT_TRUE(copied->scene.objects.empty());
}

TEST_F(SceneFile, TenThousandObjects_AreReadAsTheyWereWritten) {
    Scene scene = read(plainScene())->scene;
    scene.objects.resize(10000, scene.objects.front());
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        scene.objects[i].name = std::to_string(i) + std::string(600, 'x');
    }
    ASSERT_TRUE(writeScene(file_, scene));
    ASSERT_GT(std::filesystem::file_size(file_), JsonLimits().bytes);
    const auto reading = readScene(file_, sceneCatalog());
    ASSERT_TRUE(reading) << text(reading.error());
    EXPECT_TRUE(reading->scene == scene);
}

TEST_F(SceneFile, MissingPresetFileOfTwoObjects_IsOneNote) {
    json scene = plainScene();
    scene["objects"][0]["preset"] = "nowhere.patina.json";
    scene["objects"].push_back(scene["objects"][0]);
    EXPECT_EQ(read(scene)->notes.size(), 1u);
}

TEST_F(SceneFile, MissingPresetFile_IsANoteThatNamesIt) {
    const auto reading = readObject({{"preset", "none.patina.json"}});
    ASSERT_TRUE(reading);
    EXPECT_NE(text(reading->notes).find("none.patina.json"), std::string::npos);
}

TEST_F(SceneFile, MissingPresetFile_IsToldWhereTheSceneNamesIt) {
    const auto reading = readObject({{"preset", "none.patina.json"}});
    ASSERT_TRUE(reading);
    ASSERT_EQ(reading->notes.size(), 1u);
    EXPECT_EQ(reading->notes[0].file, file_.string());
    EXPECT_GT(reading->notes[0].line, 0);
}

TEST_F(SceneFile, DamagedPreset_IsANoteAtItsPlace) {
    const auto reading = readObject({{"preset", {{"parameters", {{"gloss", "x"}}}}}});
    ASSERT_TRUE(reading);
    const std::string before = tests::readFile(file_);
    const auto value = before.begin() + static_cast<std::ptrdiff_t>(before.find("\"x\""));
    ASSERT_EQ(reading->notes.size(), 1u);
    EXPECT_EQ(reading->notes[0].line, 1 + std::count(before.begin(), value, '\n'));
}

TEST_F(SceneFile, DamagedPreset_IsKept) {
    json damaged = preset();
    damaged["parameters"]["gloss"] = "x";
    const auto reading = readObject({{"preset", damaged}});
    EXPECT_EQ(reading->scene.objects[0].material.extras["damagedPreset"], damaged);
}

TEST_F(SceneFile, DamagedPreset_LeavesTheRestOfTheScene) {
    EXPECT_EQ(readObject({{"preset", 5}})->scene.lights.size(), 1u);
}

TEST_F(SceneFile, LightsAndFog_HaveTheirValues) {
    const Scene scene = read(plainScene())->scene;
    EXPECT_EQ(scene.lights[0].block.parameters, (Values{{"gloss", 0.25}}));
    EXPECT_EQ(scene.part(kinds::fog)->parameters, (Values{{"gloss", 0.125}}));
}

TEST_F(SceneFile, Shadow_IsReadAndWrittenWithItsLight) {
    const json shadow{{"id", "veil"}, {"version", 1}, {"parameters", {{"gloss", 0.5}}}, {"x", 7}};
    const auto reading = readChanged({{"lights", {{{"id", "lamp"}, {"shadow", shadow}}}}});
    EXPECT_EQ(text(reading->notes), "");
    ASSERT_TRUE(reading->scene.lights[0].part(kinds::shadows));
    EXPECT_EQ(reading->scene.lights[0].part(kinds::shadows)->parameters, (Values{{"gloss", 0.5}}));
    EXPECT_EQ(toJson(reading->scene, folder_.path())["lights"][0]["shadow"], shadow);
}

TEST_F(SceneFile, LightWithoutShadow_IsWrittenWithNone) {
    const Scene scene = read(plainScene())->scene;
    EXPECT_FALSE(scene.lights[0].part(kinds::shadows));
    EXPECT_TRUE(toJson(scene, folder_.path())["lights"][0]["shadow"].is_null());
}

TEST_F(SceneFile, Ground_IsReadAndWritten) {
    const json ground{{"mode", "plane"},           {"automatic", false}, {"height", -0.5},
                      {"color", {0.25, 0.5, 1.0}}, {"opacity", 0.75},    {"later", 1}};
    const auto reading = readChanged({{"ground", ground}});
    EXPECT_EQ(text(reading->notes), "");
    const Ground expected{GroundMode::Plane, false, -0.5, {0.25, 0.5, 1.0}, 0.75};
    EXPECT_EQ(reading->scene.ground, expected);
    EXPECT_EQ(toJson(reading->scene, folder_.path())["ground"], ground);
}

TEST_F(SceneFile, UnknownGround_IsOffWithANoteAtItsPlace) {
    const auto reading = readChanged({{"ground", {{"mode", "sand"}}}});
    EXPECT_EQ(reading->scene.ground.mode, GroundMode::Off);
    ASSERT_EQ(reading->notes.size(), 1u);
    EXPECT_GT(reading->notes[0].line, 1);
}

TEST_F(SceneFile, ObjectThatCastsNoShadow_StaysSo) {
    const Scene scene = readObject({{"castsShadow", false}})->scene;
    EXPECT_FALSE(scene.objects[0].castsShadow);
    EXPECT_EQ(toJson(scene, folder_.path())["objects"][0]["castsShadow"], false);
}

TEST_F(SceneFile, UnknownLight_IsKeptWithANote) {
    const auto reading = readChanged({{"lights", {{{"id", "torch"}, {"parameters", {{"x", 1}}}}}}});
    EXPECT_EQ(reading->notes.size(), 1u);
    EXPECT_EQ(toJson(reading->scene, folder_.path())["lights"][0]["parameters"]["x"], 1);
}

TEST_F(SceneFile, RelativeMesh_IsAbsoluteInTheValue) {
    EXPECT_EQ(readObject({{"mesh", "m/x.obj"}})->scene.objects[0].mesh,
              (folder_ / "m/x.obj").string());
}

TEST_F(SceneFile, Mesh_IsWrittenRelative) {
    const Scene scene = readObject({{"mesh", "m/x.obj"}})->scene;
    EXPECT_EQ(toJson(scene, folder_.path())["objects"][0]["mesh"], "m/x.obj");
}

TEST_F(SceneFile, Mesh_FollowsASceneSavedElsewhere) {
    const Scene scene = readObject({{"mesh", "m/x.obj"}})->scene;
    const auto deeper = folder_ / "deep/b.patina-scene.json";
    std::filesystem::create_directories(deeper.parent_path());
    ASSERT_TRUE(writeScene(deeper, scene));
    EXPECT_EQ(readScene(deeper, sceneCatalog())->scene.objects[0].mesh,
              (folder_ / "m/x.obj").string());
}

TEST_F(SceneFile, AbsoluteMesh_IsNotedAndKept) {
    const auto reading = readObject({{"mesh", "/somewhere/x.obj"}});
    EXPECT_EQ(reading->notes.size(), 1u);
    EXPECT_EQ(reading->scene.objects[0].mesh, "/somewhere/x.obj");
}

TEST_F(SceneFile, UnknownBuiltinMesh_IsNotedWithTheNames) {
    const std::string notes = text(readObject({{"mesh", "builtin:shpere"}})->notes);
    EXPECT_NE(notes.find("expected 'sphere'"), std::string::npos) << notes;
}

TEST_F(SceneFile, ScaleOfZero_BecomesUsable) {
    const auto reading = readObject({{"scale", {0, 1, 1}}});
    EXPECT_GT(reading->scene.objects[0].scale.x, 0.0);
    EXPECT_EQ(reading->notes.size(), 1u);
}

TEST_F(SceneFile, NegativeScale_Mirrors) {
    EXPECT_EQ(readObject({{"scale", {-2, 1, 1}}})->scene.objects[0].scale.x, -2.0);
}

TEST_F(SceneFile, Shear_IsWrittenWhereThereIsSome) {
    const Scene slanted = readObject({{"shear", {0.5, 0, -0.25}}})->scene;
    EXPECT_EQ(slanted.objects[0].shear, glm::dvec3(0.5, 0.0, -0.25));
    EXPECT_EQ(toJson(slanted, folder_.path())["objects"][0]["shear"], json({0.5, 0, -0.25}));
    EXPECT_FALSE(
        toJson(readObject(json::object())->scene, folder_.path())["objects"][0].contains("shear"));
}

TEST_F(SceneFile, CameraOutOfRange_IsBroughtIn) {
    const Camera camera = readChanged({{"camera",
                                        {{"distance", 0},
                                         {"pitch", 1000},
                                         {"fieldOfView", 0},
                                         {"yaw", 1e300},
                                         {"pivot", {1e30, 0, 0}}}}})
                              ->scene.camera;
    EXPECT_GT(camera.distance, 0.0);
    EXPECT_EQ(camera.pitch, 90.0);
    EXPECT_EQ(camera.fieldOfView, 1.0);
    EXPECT_TRUE(std::isfinite(viewMatrix(camera)[3][0]));
}

TEST_F(SceneFile, NegativeBackground_IsBroughtIn) {
    EXPECT_EQ(readChanged({{"background", {-1, 0, 0}}})->scene.background, glm::dvec3(0.0));
}

TEST_F(SceneFile, UnknownToneMapping_IsNotedWithTheWords) {
    const std::string notes = text(readChanged({{"toneMapping", "film"}})->notes);
    EXPECT_NE(notes.find("there is no tone curve \"film\""), std::string::npos) << notes;
}

TEST_F(SceneFile, NewerVersion_IsReadOnly) {
    EXPECT_TRUE(readChanged({{"version", 99}})->readOnly);
}

TEST_F(SceneFile, Preset_IsNoScene) {
    EXPECT_FALSE(read(preset()));
}

TEST_F(SceneFile, WrongTypes_AreAllReported) {
    const auto reading = readChanged(
        {{"objects", 5}, {"lights", {5}}, {"fog", true}, {"camera", "x"}, {"ambient", {1, 2}}});
    ASSERT_FALSE(reading);
    EXPECT_EQ(reading.error().size(), 5u) << text(reading.error());
}

TEST_F(SceneFile, PictureOfTheEnvironment_IsNamedFromTheScenesFolder) {
    const auto reading = read(plainScene());
    ASSERT_TRUE(reading && reading->scene.part(kinds::environment));
    EXPECT_EQ(reading->scene.part(kinds::environment)->parameters.at("picture"),
              Value((folder_ / "sky.hdr").generic_string()));
    EXPECT_EQ(toJson(reading->scene, folder_.path())["environment"]["parameters"]["picture"],
              "sky.hdr");
}

TEST_F(SceneFile, PictureOutsideTheFolder_IsNotedAtItsPlace) {
    const auto reading =
        readChanged({{"environment", {{"parameters", {{"picture", "../sky.hdr"}}}}}});
    ASSERT_TRUE(reading);
    const auto& notes = reading->notes;
    ASSERT_EQ(notes.size(), 1u);
    EXPECT_NE(notes[0].problem.find("../sky.hdr"), std::string::npos);
    EXPECT_GT(notes[0].line, 1);
}

TEST_F(SceneFile, EnvironmentOfFormerFiles_IsNoneAndIsKept) {
    json scene = plainScene();
    scene["environment"] = {{"whatever", 1}};
    const auto reading = read(scene);
    ASSERT_TRUE(reading);
    EXPECT_FALSE(reading->scene.part(kinds::environment));
    EXPECT_EQ(toJson(reading->scene, folder_.path())["environment"]["whatever"], 1);
}

TEST_F(SceneFile, FormerIdOfABlock_IsReadAsTheOneItHasNow) {
    const auto reading = readChanged({{"fog", {{"id", "haze"}}}});
    ASSERT_TRUE(reading && reading->scene.part(kinds::fog));
    EXPECT_EQ(reading->scene.part(kinds::fog)->id, "mist");
    EXPECT_EQ(reading->scene.part(kinds::fog)->parameters, (Values{{"gloss", 0.125}}));
    EXPECT_TRUE(reading->notes.empty());
    EXPECT_EQ(toJson(reading->scene, folder_.path())["fog"]["id"], "mist");
}

TEST_F(SceneFile, Transparency_ComesBack) {
    const auto reading = readChanged(
        {{"transparency", {{"id", "glass"}, {"parameters", {{"gloss", 0.5}}}, {"later", 1}}}});
    ASSERT_TRUE(reading && reading->scene.part(kinds::transparency));
    EXPECT_EQ(reading->scene.part(kinds::transparency)->parameters.at("gloss"), Value(0.5));
    const json written = toJson(reading->scene, folder_.path());
    EXPECT_EQ(written["transparency"]["later"], 1);
    const auto again = read(written);
    ASSERT_TRUE(again);
    EXPECT_EQ(again->scene.parts, reading->scene.parts);
}

TEST_F(SceneFile, Passes_ComeBackInTheirOrder) {
    const json brush{{"id", "brush"}, {"parameters", {{"gloss", 0.5}}}, {"later", 1}};
    const json unheard{{"id", "unheard"}, {"parameters", {{"size", 2}}}};
    const auto reading = readChanged({{"passes", json::array({brush, unheard, brush})}});
    ASSERT_TRUE(reading);
    ASSERT_EQ(reading->scene.passes.size(), 3u);
    EXPECT_EQ(reading->scene.passes[2].parameters.at("gloss"), Value(0.5));
    const json written = toJson(reading->scene, folder_.path());
    EXPECT_EQ(written["passes"][0]["later"], 1);
    EXPECT_EQ(written["passes"][1]["id"], "unheard");
    const auto again = read(written);
    ASSERT_TRUE(again);
    EXPECT_EQ(again->scene.passes, reading->scene.passes);
}

TEST_F(SceneFile, SceneWithoutPasses_HasNoKeyOfTheirs) {
    EXPECT_FALSE(toJson(read(plainScene())->scene, folder_.path()).contains("passes"));
}

TEST_F(SceneFile, Hemisphere_ComesBack) {
    const auto reading = readChanged(
        {{"hemisphere", {{"sky", {0.25, 0.5, 1}}, {"ground", {0.125, 0, 0}}, {"up", {1, 0, 0}}}}});
    ASSERT_TRUE(reading);
    const Hemisphere expected{{0.25, 0.5, 1.0}, {0.125, 0.0, 0.0}, {1.0, 0.0, 0.0}};
    EXPECT_EQ(reading->scene.hemisphere, expected);
    EXPECT_EQ(read(toJson(reading->scene, folder_.path()))->scene.hemisphere, expected);
}

TEST_F(SceneFile, MissingFile_IsAnError) {
    EXPECT_FALSE(readScene(folder_ / "none.patina-scene.json", sceneCatalog()));
}

TEST_F(SceneFile, UnknownKeysOfEveryObject_AreWrittenBackUntouched) {
    json scene = toJson(read(plainScene())->scene, folder_.path());
    for (const char* place :
         {"", "/objects/0", "/objects/0/preset", "/lights/0", "/lights/0/parameters", "/fog",
          "/camera", "/environment", "/extras"}) {
        scene[json::json_pointer(place)]["x-odd"] = {{"a", {1, 2.5, nullptr}}};
    }
    EXPECT_EQ(writeJson(toJson(read(scene)->scene, folder_.path())), writeJson(scene));
}

TEST_F(SceneFile, Written_ReadsAsTheSameScene) {
    Scene before = read(plainScene())->scene;
    before.exposure = 1.5;
    before.objects[0].rotation = {10.0, 20.0, 30.0};
    ASSERT_TRUE(writeScene(file_, before));
    EXPECT_EQ(readScene(file_, sceneCatalog())->scene, before);
}

TEST_F(SceneFile, NumbersThatAreNoFloats_AreWrittenAsTheyComeBack) {
    Scene scene = read(plainScene())->scene;
    scene.camera = {{0.1, 1.0 / 3.0, 1e-9}, 28.600000000000005, 0.7, 7.7330473993980835, 35.1};
    scene.objects[0].translation = {0.1, 0.2, 0.3};
    scene.objects[0].rotation = {10.1, 20.2, 30.3};
    scene.objects[0].scale = {0.1, 1.1, 2.1};
    scene.objects[0].material.opacity = 0.1;
    scene.hemisphere.sky = glm::dvec3(0.1);
    scene.ground.height = 0.1;
    scene.exposure = 0.1;
    ASSERT_TRUE(writeScene(file_, scene));
    const std::string first = tests::readFile(file_);
    EXPECT_NE(first.find("\"yaw\": 28.6\n"), std::string::npos) << first;
    ASSERT_TRUE(writeScene(file_, readScene(file_, sceneCatalog())->scene));
    EXPECT_EQ(tests::readFile(file_), first);
}

TEST_F(SceneFile, Written_FollowsTheSchema) {
    const json scene = toJson(read(plainScene())->scene, folder_.path());
    EXPECT_EQ(text(checkSchema(*parseJson(writeJson(scene), "s"), "scene")), "");
}

TEST(MeshPath, Builtin_StaysAsItIs) {
    EXPECT_EQ(meshFromFile("builtin:sphere", "/a"), "builtin:sphere");
    EXPECT_EQ(meshForFile("builtin:sphere", "/a"), "builtin:sphere");
}

TEST(MeshPath, DotsInAPath_AreResolved) {
    EXPECT_EQ(meshFromFile("../b/x.obj", "/a/c"), "/a/b/x.obj");
}

} // namespace
} // namespace patina::scene_file_test
