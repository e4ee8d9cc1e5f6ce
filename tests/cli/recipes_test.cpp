// SPDX-License-Identifier: GPL-3.0-or-later
// The command that CONTRIBUTING.md shows, as it stands there.
#include <CLI/CLI.hpp>
#include <gtest/gtest.h>

#include "cli/patina_program.h"
#include "scene/scene_file.h"

namespace patina {
#include "cli/objects_declaration.h"
} // namespace patina

namespace patina::tests::recipes_test {
namespace {

struct Ended {
    int status = -1;
    std::string out;
    std::string err;
};

Ended objectsOf(const std::string& file) {
    CLI::App program;
    Ended ended;
    addObjects(program, ended.status);
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    program.parse(std::vector<std::string>{file, "objects"}); // the last word first
    ended.out = testing::internal::GetCapturedStdout();
    ended.err = testing::internal::GetCapturedStderr();
    return ended;
}

TEST(CommandOfTheGuide, Scene_IsCounted) {
    const TemporaryFolder folder;
    Scene scene;
    scene.objects.resize(3);
    ASSERT_TRUE(writeScene(folder / "three.json", scene));
    const Ended ended = objectsOf(folder / "three.json");
    EXPECT_EQ(ended.status, 0) << ended.err;
    EXPECT_EQ(ended.out, "3\n");
}

TEST(CommandOfTheGuide, MissingScene_IsAnError) {
    const Ended ended = objectsOf("/nowhere/a.json");
    EXPECT_EQ(ended.status, 1);
    EXPECT_EQ(ended.out, "");
    EXPECT_NE(ended.err.find("/nowhere/a.json: no such file"), std::string::npos) << ended.err;
}

} // namespace
} // namespace patina::tests::recipes_test
