// SPDX-License-Identifier: GPL-3.0-or-later
// What a scene or a preset may read beside itself.

#include <gtest/gtest.h>

#include "catalog_fixture.h"
#include "scene/scene_file.h"

namespace patina::outside_files_test {
namespace {

using nlohmann::json;
using Kind = OutsideFile::Kind;

json preset(const std::string& image = {}) {
    json preset{{"format", "patina.preset"}, {"version", 1}, {"model", {{"id", "velvet"}}}};
    if (!image.empty()) {
        preset["textures"]["normal"]["file"] = image;
    }
    return preset;
}

const Catalog& smallCatalog() {
    static const Catalog made = [] {
        tests::BlockFolder folder;
        folder.add("models", tests::plainDescriptor("velvet"));
        json panorama = tests::plainDescriptor("panorama");
        panorama["parameters"].push_back(
            {{"id", "picture"}, {"label", "Picture"}, {"type", "texture"}, {"default", ""}});
        folder.add("environment", panorama);
        return folder.load();
    }();
    return made;
}

class OutsideFilesTest : public testing::Test {
  protected:
    OutsideFilesTest() {
        std::filesystem::create_directories(folder_ / "home/looks");
        std::filesystem::create_directories(folder_ / "other");
        write("other/velvet.patina.json", preset("bumps.png"));
        write("home/looks/velvet.patina.json", preset("../bumps.png"));
    }

    void write(const std::string& name, const json& content) const {
        tests::writeFile(folder_ / name, writeJson(content));
    }
    std::string path(const std::string& name) const { return (folder_ / name).generic_string(); }
    SceneReading readScene(const json& scene, const ReadingRights& rights = {},
                           const std::string& name = "home/a.patina-scene.json") const {
        json whole{{"format", "patina.scene"}, {"version", 1}};
        whole.update(scene);
        write(name, whole);
        const auto reading = patina::readScene(folder_ / name, smallCatalog(), rights);
        EXPECT_TRUE(reading) << text(reading.error());
        return reading.value_or(SceneReading());
    }
    static json withMesh(const std::string& mesh) {
        return {{"objects", {{{"mesh", mesh}, {"preset", preset()}}}}};
    }
    static json withPreset(const json& preset) {
        return {{"objects", {{{"mesh", "builtin:sphere"}, {"preset", preset}}}}};
    }
    static json withPicture(const std::string& file) {
        return {{"environment", {{"id", "panorama"}, {"parameters", {{"picture", file}}}}}};
    }

    tests::TemporaryFolder folder_;
};

TEST_F(OutsideFilesTest, MeshInTheFolder_IsRead) {
    EXPECT_EQ(readScene(withMesh("meshes/a.obj")).outside, OutsideFiles());
}

TEST_F(OutsideFilesTest, MeshOutside_IsNotReadUnasked) {
    const SceneReading reading = readScene(withMesh("../other/a.obj"));
    EXPECT_EQ(reading.outside, (OutsideFiles{{Kind::Mesh, path("other/a.obj")}}));
    EXPECT_NE(text(reading.notes)
                  .find("\"../other/a.obj\" is not in the scene's folder and is "
                        "not read"),
              std::string::npos);
}

TEST_F(OutsideFilesTest, MeshBehindALinkOutOfTheFolder_IsOutside) {
    std::filesystem::create_directory_symlink("../other", folder_ / "home/linked");
    EXPECT_EQ(readScene(withMesh("linked/a.obj")).outside,
              (OutsideFiles{{Kind::Mesh, path("home/linked/a.obj")}}));
}

TEST_F(OutsideFilesTest, FullPathIntoTheFolder_IsInside) {
    EXPECT_EQ(readScene(withMesh(path("home/a.obj"))).outside, OutsideFiles());
}

TEST_F(OutsideFilesTest, PictureOutside_IsNotReadUnasked) {
    EXPECT_EQ(readScene(withPicture("../other/sky.hdr")).outside,
              (OutsideFiles{{Kind::Picture, path("other/sky.hdr")}}));
}

TEST_F(OutsideFilesTest, PresetOutside_IsNotReadAndKept) {
    const SceneReading reading = readScene(withPreset("../other/velvet.patina.json"));
    EXPECT_EQ(reading.outside, (OutsideFiles{{Kind::Preset, path("other/velvet.patina.json")}}));
    const Material& material = reading.scene.objects.at(0).material;
    EXPECT_EQ(material.extras["damagedPreset"], "../other/velvet.patina.json");
    EXPECT_TRUE(material.textures.empty());
}

TEST_F(OutsideFilesTest, PresetThatWasAllowed_IsReadWithTheImagesBesideIt) {
    const SceneReading reading = readScene(withPreset("../other/velvet.patina.json"),
                                           {{}, {path("other/velvet.patina.json")}, false});
    EXPECT_EQ(reading.outside, OutsideFiles());
    EXPECT_FALSE(reading.scene.objects.at(0).material.textures.at("normal").outside);
}

/// The user agreed to the preset, not to what that names.
TEST_F(OutsideFilesTest, ImageOutsideOfAnAllowedPreset_IsAskedForToo) {
    write("other/velvet.patina.json", preset("/etc/secret.png"));
    EXPECT_EQ(readScene(withPreset("../other/velvet.patina.json"),
                        {{}, {path("other/velvet.patina.json")}, false})
                  .outside,
              (OutsideFiles{{Kind::Image, "/etc/secret.png"}}));
}

TEST_F(OutsideFilesTest, ImageOfAPresetBelow_MayLieAnywhereInTheScenesFolder) {
    const SceneReading reading = readScene(withPreset("looks/velvet.patina.json"));
    EXPECT_FALSE(reading.scene.objects.at(0).material.textures.at("normal").outside);
}

TEST_F(OutsideFilesTest, ImageOfAnInlinePreset_IsListed) {
    EXPECT_EQ(readScene(withPreset(preset("../other/bumps.png"))).outside,
              (OutsideFiles{{Kind::Image, path("other/bumps.png")}}));
}

TEST_F(OutsideFilesTest, NamedTwice_IsListedOnce) {
    json scene = withMesh("../other/a.obj");
    scene["objects"].push_back(scene["objects"][0]);
    EXPECT_EQ(readScene(scene).outside.size(), 1u);
}

TEST_F(OutsideFilesTest, EverythingAllowed_ListsNothing) {
    const ReadingRights everything{.everything = true};
    EXPECT_EQ(readScene(withMesh("../other/a.obj"), everything).outside, OutsideFiles());
    EXPECT_EQ(readScene(withPicture("../other/sky.hdr"), everything).outside, OutsideFiles());
    EXPECT_EQ(readScene(withPreset("../other/velvet.patina.json"), everything).outside,
              OutsideFiles());
}

TEST_F(OutsideFilesTest, ShippedData_IsInside) {
    const std::string shipped = (dataFolder() / "presets/default.patina-scene.json").string();
    EXPECT_EQ(readScene(withMesh(shipped)).outside, OutsideFiles());
}

/// A copy of unsaved work lies elsewhere: what counts is the file it came from.
TEST_F(OutsideFilesTest, CopyElsewhere_CountsAsTheFileItCameFrom) {
    ReadingRights rights;
    rights.folder = referenceFolder(folder_ / "home/a.patina-scene.json");
    const std::string copy = "other/copy.patina-scene.json";
    EXPECT_EQ(readScene(withMesh("../home/a.obj"), rights, copy).outside, OutsideFiles());
    EXPECT_EQ(readScene(withMesh("a.obj"), rights, copy).outside,
              (OutsideFiles{{Kind::Mesh, path("other/a.obj")}}));
}

TEST_F(OutsideFilesTest, ReferenceFolder_IsTheFilesOwn) {
    EXPECT_EQ(referenceFolder("/a/b/../c.patina.json"), "/a");
    EXPECT_EQ(referenceFolder({}), std::filesystem::path());
}

} // namespace
} // namespace patina::outside_files_test
