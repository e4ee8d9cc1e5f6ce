// SPDX-License-Identifier: GPL-3.0-or-later
// A file of measurements opens as a material, and a preset names it by a relative path.
#include "material/measured_preset.h"

#include <numbers>

#include <gtest/gtest.h>

#include "support/measured_files.h"
#include "support/program.h"

namespace patina::measured_preset_test {
namespace {

const Catalog& shippedCatalog() {
    static const Catalog shipped = loadCatalog(
        std::vector{BlockRoot{std::filesystem::path(PATINA_SOURCE_DIR) / "shaders", true}});
    return shipped;
}

class MeasuredPreset : public testing::Test {
  protected:
    MeasuredPreset() {
        std::filesystem::create_directory(folder_ / "inside");
        for (const char* name : {"paint.binary", "inside/paint.binary"}) {
            tests::writeFile(folder_ / name, tests::merlBytes({2, 2, 2}, [](const DirectionPair&) {
                                 return glm::dvec3(0.5 / std::numbers::pi);
                             }));
        }
    }

    static std::string fileOf(const Material& material) {
        const Block& model = *shippedCatalog().find(kinds::models, material.model.id);
        return std::get<std::string>(material.model.parameters.at(tableParameter(model)->id));
    }

    /// Saves the material of a file as a preset in `inside`, and reads that.
    PresetReading savedAndRead(const std::string& measured, const ReadingRights& rights = {}) {
        const auto opened = readPreset(folder_ / measured, shippedCatalog());
        EXPECT_TRUE(opened);
        const std::filesystem::path preset = folder_ / "inside/a.patina.json";
        EXPECT_TRUE(writePreset(preset, opened->material, shippedCatalog()));
        return *readPreset(preset, shippedCatalog(), rights);
    }

    tests::TemporaryFolder folder_;
};

TEST_F(MeasuredPreset, File_IsAMaterialThatIsReadOnly) {
    const auto opened = readPreset(folder_ / "paint.binary", shippedCatalog());
    ASSERT_TRUE(opened);
    EXPECT_TRUE(opened->readOnly);
    EXPECT_EQ(opened->material.name, "paint");
    EXPECT_EQ(fileOf(opened->material), (folder_ / "paint.binary").string());
}

TEST_F(MeasuredPreset, FileBesideIt_IsNamedByARelativePath) {
    const PresetReading reading = savedAndRead("inside/paint.binary");
    EXPECT_TRUE(reading.notes.empty()) << text(reading.notes);
    EXPECT_EQ(fileOf(reading.material), (folder_ / "inside/paint.binary").string());
    const std::string json = tests::readFile(folder_ / "inside/a.patina.json");
    EXPECT_NE(json.find("\"paint.binary\""), std::string::npos) << json;
}

TEST_F(MeasuredPreset, FileOutsideItsFolder_IsKeptButNotReadUnlessAllowed) {
    const PresetReading reading = savedAndRead("paint.binary");
    EXPECT_EQ(fileOf(reading.material), "");
    EXPECT_EQ(reading.outside.size(), 1u);
    EXPECT_EQ(reading.material.parked.size(), 1u);
    ReadingRights all;
    all.everything = true;
    EXPECT_EQ(std::filesystem::weakly_canonical(fileOf(savedAndRead("paint.binary", all).material)),
              std::filesystem::weakly_canonical(folder_ / "paint.binary"));
}

TEST_F(MeasuredPreset, DamagedFile_IsAnErrorWithItsName) {
    tests::writeFile(folder_ / "text.binary", "no numbers at all, but text of some length");
    const auto opened = readPreset(folder_ / "text.binary", shippedCatalog());
    ASSERT_FALSE(opened);
    EXPECT_NE(text(opened.error()).find("text.binary"), std::string::npos);
}

} // namespace
} // namespace patina::measured_preset_test
