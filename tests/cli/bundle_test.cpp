// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>

#include <gtest/gtest.h>

#include "cli/patina_program.h"

namespace patina::tests::bundle_test {
namespace {

namespace fs = std::filesystem;

/// Exports a preset that ships and imports it below folder / "out".
void takeThrough(const TemporaryFolder& folder, const fs::path& preset) {
    const std::string zip = (folder / "set.zip").string();
    const Outcome exported = patina({"export", (shipped("presets") / preset).string(), "-o", zip});
    ASSERT_EQ(exported.exitCode, 0) << exported.err;
    const Outcome imported = patina({"import", zip, "--into", (folder / "out").string()});
    ASSERT_EQ(imported.exitCode, 0) << imported.err;
}

TEST(Bundle, ExportedPreset_IsImportedAsItWas) {
    const TemporaryFolder folder;
    takeThrough(folder, "lambert/grey-card.patina.json");
    EXPECT_EQ(readFile(folder / "out/set/grey-card.patina.json"),
              readFile(shipped("presets") / "lambert/grey-card.patina.json"));
}

TEST(Bundle, ImageOfAnExportedPreset_LiesBesideItUnchanged) {
    const TemporaryFolder folder;
    takeThrough(folder, "lambert/plaster.patina.json");
    EXPECT_NE(readFile(folder / "out/set/plaster.patina.json")
                  .find("\"file\": \"images/concrete-normal.png\""),
              std::string::npos);
    EXPECT_EQ(readFile(folder / "out/set/images/concrete-normal.png"),
              readFile(shipped("presets") / "images/concrete-normal.png"));
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
