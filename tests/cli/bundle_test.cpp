// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>

#include <gtest/gtest.h>

#include "cli/patina_program.h"

namespace patina::tests::bundle_test {
namespace {

namespace fs = std::filesystem;

TEST(Bundle, ExportedPreset_IsImportedAsItWas) {
    const TemporaryFolder folder;
    const fs::path preset = shipped("presets") / "lambert/plaster.patina.json";
    const std::string zip = (folder / "set.zip").string();
    const Outcome exported = patina({"export", preset.string(), "-o", zip});
    ASSERT_EQ(exported.exitCode, 0) << exported.err;
    const Outcome imported = patina({"import", zip, "--into", (folder / "out").string()});
    ASSERT_EQ(imported.exitCode, 0) << imported.err;
    EXPECT_EQ(readFile(folder / "out/set/plaster.patina.json"), readFile(preset));
}

TEST(Bundle, FileThatIsNoZip_IsRefused) {
    const TemporaryFolder folder;
    writeFile(folder / "set.zip", "text");
    const Outcome outcome =
        patina({"import", (folder / "set.zip").string(), "--into", (folder / "out").string()});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_NE(outcome.err.find("it is no zip file"), std::string::npos) << outcome.err;
}

} // namespace
} // namespace patina::tests::bundle_test
