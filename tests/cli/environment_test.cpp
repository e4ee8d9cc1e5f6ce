// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "cli/patina_program.h"

namespace patina::tests::environment_test {
namespace {

std::vector<std::string> rendering(std::vector<std::string> more) {
    std::vector<std::string> arguments{"render", gold, "--size", "32x32", "--samples", "16", "-o",
                                       "-"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

TEST(EnvironmentOption, Studio_ChangesThePicture) {
    const Outcome plain = patina(rendering({}));
    const Outcome lit = patina(rendering({"--environment", "studio"}));
    ASSERT_EQ(lit.exitCode, 0) << lit.err;
    EXPECT_NE(lit.out, plain.out);
}

TEST(EnvironmentOption, DarkStudio_IsAsNone) {
    const Outcome dark =
        patina(rendering({"--environment", "studio", "--set", "environment.intensity=0"}));
    ASSERT_EQ(dark.exitCode, 0) << dark.err;
    EXPECT_EQ(dark.out, patina(rendering({"--environment", "none"})).out);
}

TEST(EnvironmentOption, Panorama_LightsAndStandsBehind) {
    const TemporaryFolder folder;
    const std::string file = (folder / "sky.exr").string();
    ASSERT_EQ(patina({"render", gold, "--size", "64x32", "-o", file}).exitCode, 0);
    const Outcome lit = patina(rendering({"--environment", file}));
    ASSERT_EQ(lit.exitCode, 0) << lit.err;
    EXPECT_NE(lit.out, patina(rendering({})).out);
    const Outcome hidden =
        patina(rendering({"--environment", file, "--set", "environment.background=hidden"}));
    EXPECT_NE(hidden.out, lit.out);
}

TEST(EnvironmentOption, UnknownName_IsAnErrorWithTheNames) {
    const Outcome outcome = patina(rendering({"--environment", "nowhere"}));
    EXPECT_NE(outcome.exitCode, 0);
    EXPECT_NE(outcome.err.find("studio"), std::string::npos) << outcome.err;
}

TEST(EnvironmentOption, FileThatIsNoPicture_IsAnErrorThatNamesIt) {
    const TemporaryFolder folder;
    writeFile((folder / "sky.hdr").string(), "no picture");
    const Outcome outcome = patina(rendering({"--environment", (folder / "sky.hdr").string()}));
    EXPECT_NE(outcome.exitCode, 0);
    EXPECT_NE(outcome.err.find("sky.hdr"), std::string::npos) << outcome.err;
}

TEST(EnvironmentOption, PictureOfASceneThatIsGone_IsAWarningAndAPlaceholder) {
    const TemporaryFolder folder;
    const std::string scene = (folder / "place.scene.json").string();
    writeFile(scene, R"({"format": "patina.scene", "version": 1,
        "objects": [{"name": "Ball", "mesh": "builtin:sphere", "preset": {
            "format": "patina.preset", "version": 1, "model": {"id": "lambert", "version": 1}}}],
        "environment": {"id": "image", "version": 1, "parameters": {"image": "gone.hdr"}}})");
    const Outcome outcome =
        patina({"render", "--scene", scene, "--size", "32x32", "--samples", "16", "-o", "-"});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_NE(outcome.err.find("gone.hdr"), std::string::npos) << outcome.err;
    EXPECT_FALSE(outcome.out.empty());
    const Outcome effects = patina({"effects", "--scene", scene, "--no-cost"});
    EXPECT_NE(effects.out.find("a placeholder sends light"), std::string::npos) << effects.out;
}

TEST(EnvironmentOption, Effects_NameIt) {
    const Outcome outcome = patina({"effects", gold, "--environment", "studio", "--no-cost"});
    EXPECT_NE(outcome.out.find("environment/studio"), std::string::npos) << outcome.out;
}

} // namespace
} // namespace patina::tests::environment_test
