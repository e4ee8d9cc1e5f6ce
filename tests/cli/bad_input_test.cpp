// SPDX-License-Identifier: GPL-3.0-or-later
// Everything that artists' disks hold besides good files, as the command line meets it: a message,
// the right exit status, and never a crash.
#include <filesystem>
#include <string>

#include <unistd.h>

#include <gtest/gtest.h>

#include "cli/patina_program.h"

namespace patina::tests::bad_input_test {
namespace {

namespace fs = std::filesystem;

/// A sound preset with one place filled in.
std::string preset(const std::string& color = "[0.5, 0.5, 0.5]",
                   const std::string& shininess = "20.0", const std::string& model = "phong",
                   const std::string& version = "1", const std::string& textures = "{}") {
    return R"({"format": "patina.preset", "name": "Test", "opacity": 1.0, "version": )" + version +
           R"(, "model": {"id": ")" + model + R"(", "version": 1}, "textures": )" + textures +
           R"(, "parameters": {"diffuse.color": )" + color + R"(, "shininess": )" + shininess +
           R"(, "normalisation": "raw"}})";
}

struct BadPreset {
    const char* name;
    std::string content;
    int exitCode;
    std::string message;
};

void PrintTo(const BadPreset& bad, std::ostream* out) {
    *out << bad.name;
}

class BadPresetFile : public testing::TestWithParam<BadPreset> {
  protected:
    Outcome drawn() const {
        writeFile(folder_ / "bad.patina.json", GetParam().content);
        return patina({"render", folder_ / "bad.patina.json", "--mesh", "builtin:sphere", "--size",
                       "16x16", "-o", folder_ / "a.png"});
    }

    bool pictureIsThere() const { return fs::exists(folder_ / "a.png"); }

  private:
    TemporaryFolder folder_;
};

TEST_P(BadPresetFile, Message_SaysWhatAndWhere) {
    const Outcome outcome = drawn();
    EXPECT_NE(outcome.err.find("bad.patina.json"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find(GetParam().message), std::string::npos) << outcome.err;
}

TEST_P(BadPresetFile, Picture_IsThereExactlyWhenTheExitStatusIsZero) {
    const Outcome outcome = drawn();
    EXPECT_EQ(outcome.exitCode, GetParam().exitCode) << outcome.err;
    EXPECT_EQ(pictureIsThere(), GetParam().exitCode == 0);
}

INSTANTIATE_TEST_SUITE_P(
    All, BadPresetFile,
    testing::Values(
        BadPreset{"Empty", "", 1, ":1:1: unexpected end"},
        BadPreset{"Truncated", preset().substr(0, 100), 1, "expected"},
        BadPreset{"Binary", std::string("\x7f" "ELF\0\xff\xfe", 7), 1, "expected"},
        BadPreset{"HundredMegabytes", std::string(100'000'000, ' '), 1, "too large"},
        BadPreset{"DeeplyNested", std::string(100'000, '['), 1, "at most 64 levels"},
        BadPreset{"WrongType", "[1, 2]", 1, "expected an object"},
        BadPreset{"NotANumber", preset("[0.5, 0.5, 0.5]", "NaN"), 1, "not a JSON value"},
        BadPreset{"BeyondDoubles", preset("[0.5, 0.5, 0.5]", "1e999"), 1, "not finite"},
        BadPreset{"NumberForAColor", preset("-1"), 1, "expected a colour"},
        BadPreset{"NewerVersion", preset("[1, 1, 1]", "20.0", "phong", "99"), 0, "version 99"},
        BadPreset{"UnknownChoice",
                  [] {
                      std::string text = preset();
                      return text.replace(text.find("\"raw\""), 5, "\"odd\"");
                  }(),
                  0, "\"odd\" is no choice"},
        BadPreset{"PathOutOfTheFolder",
                  preset("[1, 1, 1]", "20.0", "phong", "1",
                         R"({"diffuse.color": {"file": "../../etc/passwd"}})"),
                  0, "not in the preset's folder"}),
    [](const auto& information) { return std::string(information.param.name); });

TEST(BadInput, MistakesOfAScene_AreToldOnceAndNothingIsDrawn) {
    const TemporaryFolder folder;
    writeFile(folder / "a.patina-scene.json",
              R"({"format": "patina.scene", "version": 1, "exposure": "bright"})");
    writeFile(folder / "a.patina.json", preset());
    const Outcome outcome =
        patina({"render", folder / "a.patina.json", "--scene", folder / "a.patina-scene.json",
                "--size", "16x16", "-o", folder / "a.png"});
    EXPECT_EQ(outcome.exitCode, 1);
    const auto said = outcome.err.find("\"bright\"");
    ASSERT_NE(said, std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.err.find("\"bright\"", said + 1), std::string::npos) << outcome.err;
    EXPECT_FALSE(fs::exists(folder / "a.png"));
}

/// A stranger's scene in a folder of its own, beside which lies what is the user's.
class StrangersScene : public testing::Test {
  protected:
    StrangersScene() {
        fs::create_directory(folder_ / "home");
        writeFile(folder_ / "secret.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        writeFile(folder_ / "secret.patina.json", preset());
    }
    Outcome drawn(const std::string& mesh, const std::string& itsPreset,
                  std::vector<std::string> more = {}) const {
        writeFile(folder_ / "home/a.patina-scene.json",
                  R"({"format": "patina.scene", "version": 1, "objects": [{"mesh": ")" + mesh +
                      R"(", "preset": )" + itsPreset + "}]}");
        std::vector<std::string> all{"render", "--scene", folder_ / "home/a.patina-scene.json",
                                     "--size", "16x16",   "-o", folder_ / "a.png"};
        all.insert(all.end(), more.begin(), more.end());
        return patina(all);
    }

    TemporaryFolder folder_;
};

TEST_F(StrangersScene, MeshOutsideItsFolder_IsReadWhenThatIsAllowed) {
    const Outcome refused = drawn("../secret.obj", preset());
    EXPECT_EQ(refused.exitCode, 1);
    EXPECT_NE(refused.err.find("\"../secret.obj\" is not in the scene's folder and is not read"),
              std::string::npos)
        << refused.err;
    EXPECT_NE(refused.err.find("--allow-outside"), std::string::npos) << refused.err;
    const Outcome allowed = drawn("../secret.obj", preset(), {"--allow-outside"});
    EXPECT_EQ(allowed.exitCode, 0) << allowed.err;
}

/// Who names the image himself agrees, as who allows all.
TEST_F(StrangersScene, ImageOfAPassOutsideItsFolder_IsReadWhenThatIsAllowedOrNamed) {
    const std::string secret = folder_ / "secret.png";
    const Outcome made =
        patina({"render", "--model", "lambert", "--size", "16x16", "-o", secret});
    ASSERT_EQ(made.exitCode, 0) << made.err;
    const std::string scene = folder_ / "home/a.patina-scene.json";
    writeFile(scene, R"({"format": "patina.scene", "version": 1, "passes": [{"id": "screen",
        "parameters": {"mark": "image", "threshold": "../secret.png"}}]})");
    std::string said;
    const auto shown = [&](std::vector<std::string> more) {
        std::vector<std::string> all{"render", "--scene", scene,  "--model", "lambert",
                                     "--size", "16x16",   "-o", folder_ / "a.png"};
        all.insert(all.end(), more.begin(), more.end());
        const Outcome outcome = patina(all);
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
        said = outcome.err;
        return readFile(folder_ / "a.png");
    };
    const std::string refused = shown({});
    EXPECT_NE(said.find("is not in the scene's folder and is not read"), std::string::npos) << said;
    const std::string allowed = shown({"--allow-outside"});
    EXPECT_NE(refused, allowed);
    EXPECT_EQ(shown({"--set", "pass.threshold=" + secret}), allowed);
}

TEST_F(StrangersScene, BufferThatItsMeshLinksOutsideTheFolder_IsReadWhenThatIsAllowed) {
    const float corners[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    writeFile(folder_ / "secret.bin", {reinterpret_cast<const char*>(corners), sizeof corners});
    writeFile(folder_ / "home/a.gltf", R"({"asset": {"version": "2.0"}, "scene": 0,
        "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                       "min": [0, 0, 0], "max": [1, 1, 0]}],
        "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 36}],
        "buffers": [{"uri": "../secret.bin", "byteLength": 36}]})");
    const Outcome refused = drawn("a.gltf", preset());
    EXPECT_EQ(refused.exitCode, 1);
    EXPECT_NE(
        refused.err.find("a.gltf: its buffer \"../secret.bin\" lies outside its folder and is "
                         "not read; expected a file beside the mesh, or in a folder there, or "
                         "--allow-outside, where you trust it"),
        std::string::npos)
        << refused.err;
    const Outcome allowed = drawn("a.gltf", preset(), {"--allow-outside"});
    EXPECT_EQ(allowed.exitCode, 0) << allowed.err;
}

TEST_F(StrangersScene, MeshThatItsSceneOfMeshesLinksOutside_IsNamedWithTheWayToAllowIt) {
    writeFile(folder_ / "home/own.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    writeFile(folder_ / "home/a.lws", "LWSC\n3\n\nLoadObjectLayer 1 own.obj\n\n"
                                      "LoadObjectLayer 1 ../secret.obj\n");
    const Outcome without = drawn("a.lws", preset());
    EXPECT_EQ(without.exitCode, 0) << without.err;
    EXPECT_NE(without.err.find("secret.obj\" lies outside its folder and is not read; expected "
                               "--allow-outside, where you trust it"),
              std::string::npos)
        << without.err;
    const Outcome with = drawn("a.lws", preset(), {"--allow-outside"});
    EXPECT_EQ(with.exitCode, 0) << with.err;
    EXPECT_EQ(with.err.find("is not read"), std::string::npos) << with.err;
}

TEST_F(StrangersScene, MeshThatTheUserNamesHimself_IsRead) {
    const Outcome outcome =
        drawn("../secret.obj", preset(), {"--mesh", folder_ / "secret.obj"});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
}

TEST_F(StrangersScene, PresetOutsideItsFolder_IsNotRead) {
    const Outcome outcome = drawn("builtin:sphere", R"("../secret.patina.json")");
    EXPECT_NE(outcome.err.find("secret.patina.json\" is not in the scene's folder and is not read"),
              std::string::npos)
        << outcome.err;
}

/// Whoever opened it waited for ever.
TEST_F(StrangersScene, PresetThatIsADevice_IsRefusedWithoutWaiting) {
    const Outcome outcome = drawn("builtin:sphere", R"("/dev/ptmx")", {"--allow-outside"});
    EXPECT_NE(outcome.err.find("this is a device"), std::string::npos) << outcome.err;
}

TEST(BadInput, UnknownModel_IsNamed) {
    const TemporaryFolder folder;
    writeFile(folder / "a.patina.json", preset("[1, 1, 1]", "20.0", "nonesuch"));
    const Outcome outcome =
        patina({"render", folder / "a.patina.json", "--size", "16x16", "-o", folder / "a.png"});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_NE(outcome.err.find("\"nonesuch\""), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("a.patina.json:"), std::string::npos) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "a.png"));
}

/// Runs patina without the right to read or write what its mode forbids, which root has.
Outcome withoutPrivileges(std::vector<std::string> arguments, const std::string& data = "") {
    const TemporaryFolder home;
    Start start{.arguments = {}, .environment = {{"XDG_CACHE_HOME", home / "cache"}}, .input = {}};
    start.environment["PATINA_DATA_DIR"] = data;
    start.environment["DISPLAY"] = "";
    if (::geteuid() != 0) {
        start.arguments = std::move(arguments);
        return run(patinaProgram(), start);
    }
    start.arguments = {"--bounding-set=-dac_override,-dac_read_search", patinaProgram().string()};
    start.arguments.insert(start.arguments.end(), arguments.begin(), arguments.end());
    return run("/usr/bin/setpriv", start);
}

TEST(BadInput, MeshWithoutPermission_SaysSo) {
    const TemporaryFolder folder;
    writeFile(folder / "a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    fs::permissions(folder / "a.obj", fs::perms::none);
    const Outcome outcome = withoutPrivileges(
        {"render", "--model", "phong", "--mesh", folder / "a.obj", "-o", folder / "a.png"});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_NE(outcome.err.find("a.obj: cannot be read: permission denied"), std::string::npos)
        << outcome.err;
}

TEST(BadInput, ReadOnlyFolder_KeepsTheOldPicture) {
    const TemporaryFolder folder;
    writeFile(folder / "a.png", "old");
    fs::permissions(folder.path(), fs::perms::owner_read | fs::perms::owner_exec);
    const Outcome outcome = withoutPrivileges(
        {"render", "--model", "phong", "--size", "16x16", "-o", folder / "a.png"});
    fs::permissions(folder.path(), fs::perms::owner_all);
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_NE(outcome.err.find("a.png: cannot be saved in its folder: Permission denied"),
              std::string::npos)
        << outcome.err;
    EXPECT_EQ(readFile(folder / "a.png"), "old");
}

TEST(BadInput, NoFileMayGrow_KeepsTheOldPicture) {
    const TemporaryFolder folder;
    writeFile(folder / "a.exr", "old");
    const Outcome outcome =
        run("/bin/sh", {.arguments = {"-c", "ulimit -f 0; exec \"$0\" \"$@\"", patinaProgram(),
                                      "render", "--model", "phong", "--size", "64x64", "-o",
                                      folder / "a.exr"},
                        .environment = {{"DISPLAY", ""}, {"XDG_CACHE_HOME", folder / "cache"}},
                        .input = {}});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_EQ(readFile(folder / "a.exr"), "old");
}

TEST(BadInput, MissingShaderFolder_IsNamed) {
    const Outcome outcome = withoutPrivileges({"models"}, "/nowhere");
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_NE(outcome.err.find(
                  "/nowhere/shaders: the folder of the lighting models cannot be read"),
              std::string::npos)
        << outcome.err;
}

TEST(BadInput, UnreadableShaderFolder_IsNamed) {
    const TemporaryFolder data;
    fs::create_directory(data / "shaders");
    fs::permissions(data / "shaders", fs::perms::none);
    const Outcome outcome = withoutPrivileges({"models"}, data.path().string());
    fs::permissions(data / "shaders", fs::perms::owner_all);
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_NE(outcome.err.find("shaders: the folder of the lighting models cannot be read: "
                               "Permission denied"),
              std::string::npos)
        << outcome.err;
}

TEST(BadInput, MoreLightsThanCanBeDrawn_AreAWarning) {
    const TemporaryFolder folder;
    std::string lights =
        R"({"enabled": true, "id": "point", "name": "", "parameters": {}, "version": 1})";
    for (int doublings = 0; doublings < 11; ++doublings) {
        lights += ", " + lights;
    }
    writeFile(folder / "a.patina-scene.json",
              R"({"format": "patina.scene", "version": 1, "lights": [)" + lights + "]}");
    const Outcome outcome = patina({"render", "--model", "phong", "--scene",
                                    folder / "a.patina-scene.json", "--size", "8x8", "-o",
                                    folder / "a.png"});
    EXPECT_NE(outcome.err.find("lights are left out"), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.exitCode, 0);
    EXPECT_TRUE(fs::exists(folder / "a.png"));
}

} // namespace
} // namespace patina::tests::bad_input_test
