// SPDX-License-Identifier: GPL-3.0-or-later
// Which presets ship: those that stay as they are.
#include <cstdlib>
#include <filesystem>

#include <gtest/gtest.h>

#include "catalog/catalog.h"
#include "support/program.h"

namespace patina::data_folder_test {
namespace {

namespace fs = std::filesystem;

using tests::TemporaryFolder;
using tests::writeFile;

/// A folder `patina` with one preset, from which Patina takes its data.
class PresetsThatShip : public testing::Test {
  protected:
    void SetUp() override {
        fs::create_directories(shipped_.parent_path());
        writeFile(shipped_, "{}");
        setenv("PATINA_DATA_DIR", (folder_ / "patina").c_str(), 1);
    }
    void TearDown() override {
        unsetenv("PATINA_DATA_DIR");
        unsetenv("XDG_DATA_HOME");
    }

    TemporaryFolder folder_;
    fs::path shipped_ = folder_ / "patina/presets/model/a.patina.json";
};

TEST_F(PresetsThatShip, PresetThatWasThere_Ships) {
    EXPECT_TRUE(isShippedPreset(shipped_));
    EXPECT_FALSE(isShippedPreset(shipped_.parent_path()));
    EXPECT_FALSE(isShippedPreset({}));
}

TEST_F(PresetsThatShip, LinkToOne_IsOneThatShips) {
    fs::create_symlink(shipped_, folder_ / "link.patina.json");
    EXPECT_TRUE(isShippedPreset(folder_ / "link.patina.json"));
}

TEST_F(PresetsThatShip, PresetThatIsPutThereLater_IsItsAuthors) {
    const fs::path added = shipped_.parent_path() / "b.patina.json";
    EXPECT_FALSE(isShippedPreset(added));
    writeFile(added, "{}");
    EXPECT_FALSE(isShippedPreset(added));
    EXPECT_TRUE(isShippedPreset(shipped_));
}

TEST_F(PresetsThatShip, PresetInTheUsersOwnFolder_NeverShips) {
    setenv("XDG_DATA_HOME", folder_.path().c_str(), 1);
    EXPECT_FALSE(isShippedPreset(shipped_));
}

} // namespace
} // namespace patina::data_folder_test
