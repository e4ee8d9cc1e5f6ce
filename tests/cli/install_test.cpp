// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "cli/patina_program.h"

namespace patina::tests::install_test {
namespace {

/// An installation under a folder that is not the configured prefix, as a packager makes it.
class Installation : public testing::Test {
  protected:
    void SetUp() override {
        const Outcome outcome = run(
            PATINA_CMAKE, Start{.arguments = {"--install", PATINA_BINARY_DIR, "--prefix", prefix()},
                                .environment = {{"DESTDIR", ""}},
                                .input = {}});
        ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    }

    std::string prefix() const { return folder_ / "usr"; }

    Outcome installed(std::vector<std::string> arguments) {
        return run(prefix() + "/bin/patina",
                   Start{.arguments = std::move(arguments),
                         .environment = {{"PATINA_DATA_DIR", ""},
                                         {"XDG_DATA_HOME", folder_ / "data"},
                                         {"XDG_CACHE_HOME", folder_ / "cache"}},
                         .input = {}});
    }

    TemporaryFolder folder_;
};

TEST_F(Installation, Program_RendersAnInstalledPreset) {
    const Outcome outcome =
        installed({"render", prefix() + "/share/patina/presets/strauss/brass.patina.json", "--size",
                   "32x32", "-o", "-"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_TRUE(outcome.out.starts_with("\x89PNG"));
}

TEST_F(Installation, Program_UsesTheInstalledShaders) {
    std::filesystem::remove(prefix() + "/share/patina/shaders/models/poulin-fournier.json");
    EXPECT_EQ(installed({"models"}).out.find("poulin-fournier"), std::string::npos);
}

TEST_F(Installation, ImagesOfPresets_AreThereWithoutTheirScript) {
    const std::filesystem::path images = prefix() + "/share/patina/presets/images";
    EXPECT_TRUE(std::filesystem::exists(images / "wood.jpg"));
    EXPECT_FALSE(std::filesystem::exists(images / "make_images.py"));
}

TEST_F(Installation, DesktopFiles_AreThere) {
    for (const char* file : {"applications/patina.desktop", "mime/packages/patina.xml",
                             "icons/hicolor/scalable/apps/patina.svg",
                             "metainfo/org.patina_editor.patina.metainfo.xml"}) {
        EXPECT_TRUE(std::filesystem::exists(prefix() + "/share/" + file)) << file;
    }
}

} // namespace
} // namespace patina::tests::install_test
