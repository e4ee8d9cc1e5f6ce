// SPDX-License-Identifier: GPL-3.0-or-later
// Zip files of presets: what goes in comes out, and nothing of a stranger's gets out of its folder.
#include "bundle/preset_bundle.h"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>
#include <zip.h>

#include "catalog/json_text.h"
#include "material/preset_file.h"
#include "material/variant.h"
#include "support/full_disk.h"
#include "support/program.h"

namespace patina::preset_bundle_test {
namespace {

namespace fs = std::filesystem;
using tests::readFile;
using tests::writeFile;

Material material(const std::string& name) {
    Material made;
    made.name = name;
    made.model.id = "lambert";
    return made;
}

class PresetBundle : public testing::Test {
  protected:
    fs::path file() const { return folder_ / "set.zip"; }
    fs::path out() const { return folder_ / "out"; }

    /// A zip file with entries of these names, of 8 bytes each.
    void writeZip(const std::vector<std::string>& names, std::uint32_t attributes = 0) const {
        void* zip = zipOpen64(file().c_str(), APPEND_STATUS_CREATE);
        for (const std::string& name : names) {
            zip_fileinfo info{};
            info.external_fa = attributes;
            ASSERT_EQ(zipOpenNewFileInZip4_64(zip, name.c_str(), &info, nullptr, 0, nullptr, 0,
                                              nullptr, Z_DEFLATED, 9, 0, -MAX_WBITS, DEF_MEM_LEVEL,
                                              Z_DEFAULT_STRATEGY, nullptr, 0, 3u << 8, 0, 0),
                      ZIP_OK);
            zipWriteInFileInZip(zip, "01234567", 8);
            zipCloseFileInZip(zip);
        }
        zipClose(zip, nullptr);
    }

    /// What was refused, by name.
    std::string refused(const BundleLimits& limits = {}) const {
        const auto import = importBundle(file(), out(), limits);
        std::string text;
        for (const BundleOutcome& outcome :
             import ? import->outcomes : std::vector<BundleOutcome>()) {
            text += outcome.problem.empty() ? "" : outcome.name + ": " + outcome.problem + "\n";
        }
        return import ? text : import.error().problem;
    }

    tests::TemporaryFolder folder_;
};

TEST_F(PresetBundle, PresetsWithImages_ComeOutAsTheyWentIn) {
    writeFile(folder_ / "bark.png", "an image");
    Material first = material("First");
    first.textures["diffuse.color"].file = (folder_ / "bark.png").string();
    setParent(first, (folder_ / "parent.patina.json").string());
    const auto exported =
        exportBundle(file(), {{"same", first, "a picture"}, {"same", material("Second")}});
    ASSERT_TRUE(exported);
    EXPECT_EQ(*exported, (std::vector<BundleOutcome>{{"same", ""}, {"same", ""}}));
    const auto import = importBundle(file(), out());
    ASSERT_TRUE(import);
    EXPECT_EQ(import->folder, out() / "set");
    const auto read = readPreset(out() / "set/same.patina.json", Catalog());
    ASSERT_TRUE(read) << text(read.error());
    EXPECT_EQ(read->material.name, "First");
    EXPECT_EQ(parentOf(read->material), "");
    EXPECT_EQ(readFile(read->material.textures.at("diffuse.color").file), "an image");
    EXPECT_TRUE(fs::exists(out() / "set/same-2.patina.json"));
    EXPECT_FALSE(fs::exists(out() / "set/pictures"));
}

TEST_F(PresetBundle, MeasuredFile_GoesWithItsPreset) {
    writeFile(folder_ / "paint.binary", "measurements");
    Material measured = material("Measured");
    measured.model.id = "measured";
    measured.model.parameters["file"] = (folder_ / "paint.binary").string();
    ASSERT_TRUE(exportBundle(file(), {{"paint", measured}}));
    ASSERT_EQ(refused(), "");
    EXPECT_EQ(readFile(out() / "set/measured/paint.binary"), "measurements");
    const auto json = nlohmann::json::parse(readFile(out() / "set/paint.patina.json"));
    EXPECT_EQ(json["parameters"]["file"], "measured/paint.binary");
}

TEST_F(PresetBundle, WithNoPresetThatCanBeRead_IsNotWritten) {
    Material lost = material("Lost");
    lost.textures["diffuse.color"].file = (folder_ / "nowhere.png").string();
    const auto outcomes = exportBundle(file(), {{"lost", lost}});
    ASSERT_TRUE(outcomes);
    EXPECT_NE(outcomes->front().problem, "");
    EXPECT_FALSE(fs::exists(file()));
}

TEST_F(PresetBundle, PresetWhoseImageIsMissing_IsLeftOutAndTold) {
    Material broken = material("Broken");
    broken.textures["diffuse.color"].file = (folder_ / "absent.png").string();
    const auto exported = exportBundle(file(), {{"broken", broken}, {"good", material("Good")}});
    ASSERT_TRUE(exported);
    EXPECT_NE(exported->at(0).problem, "");
    EXPECT_EQ(exported->at(1).problem, "");
    ASSERT_TRUE(importBundle(file(), out()));
    EXPECT_FALSE(fs::exists(out() / "set/broken.patina.json"));
}

TEST_F(PresetBundle, FilesThatMayNotBeRead_AreNotPutIntoIt) {
    writeFile(folder_ / "secret.png", "a secret");
    writeFile(folder_ / "id_rsa", "a secret");
    Material outside = material("Outside");
    outside.textures["diffuse.color"].file = (folder_ / "secret.png").string();
    outside.textures["diffuse.color"].outside = true;
    Material noImage = material("No image");
    noImage.textures["diffuse.color"].file = (folder_ / "id_rsa").string();
    const auto exported = exportBundle(
        file(), {{"outside", outside}, {"no-image", noImage}, {"good", material("Good")}});
    ASSERT_TRUE(exported);
    EXPECT_NE(exported->at(0).problem.find("outside its folder"), std::string::npos);
    EXPECT_NE(exported->at(1).problem.find("no image"), std::string::npos);
    EXPECT_EQ(exported->at(2).problem, "");
    EXPECT_EQ(readFile(file()).find("secret"), std::string::npos);
    EXPECT_EQ(readFile(file()).find("id_rsa"), std::string::npos);
}

TEST_F(PresetBundle, FullDisk_IsAnErrorAndLeavesTheOldFileAndNoOther) {
    writeFile(file(), "old");
    std::string noise(10'000, ' '); // which takes as much room packed
    std::minstd_rand random;
    std::ranges::generate(noise, [&] { return static_cast<char>(random()); });
    {
        const tests::FullDisk full(4096);
        const auto exported = exportBundle(file(), {{"large", material("Large"), noise}});
        ASSERT_FALSE(exported);
        EXPECT_EQ(exported.error().file, file().string());
    }
    {
        const tests::FullDisk full(20); // what is refused at the end, by the list of files
        EXPECT_FALSE(exportBundle(file(), {}));
    }
    EXPECT_EQ(readFile(file()), "old");
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator()), 1);
}

TEST_F(PresetBundle, PathsThatLeaveIt_AreRefusedAndTheRestIsTaken) {
    writeZip({"../a.patina.json", "/tmp/b.patina.json", "x/../../c.patina.json",
              "..\\d.patina.json", "good.patina.json"});
    EXPECT_EQ(refused(), "../a.patina.json: its path leads out of the bundle\n"
                         "/tmp/b.patina.json: its path leads out of the bundle\n"
                         "x/../../c.patina.json: its path leads out of the bundle\n"
                         "..\\d.patina.json: its path leads out of the bundle\n");
    EXPECT_TRUE(fs::exists(out() / "set/good.patina.json"));
    EXPECT_FALSE(fs::exists(out() / "a.patina.json"));
    EXPECT_FALSE(fs::exists("/tmp/b.patina.json"));
}

TEST_F(PresetBundle, LinksAndOtherFiles_AreRefused) {
    writeZip({"link.png"}, 0120777u << 16);
    EXPECT_EQ(refused(), "link.png: it is no ordinary file\n");
    EXPECT_FALSE(fs::exists(out() / "set"));
    writeZip({"run.sh", "twice.png", "twice.png"});
    EXPECT_EQ(refused(), "run.sh: it is neither a preset nor an image nor a measured file\n"
                         "twice.png: the bundle has two files of this name\n");
}

TEST_F(PresetBundle, LargerThanItMayBe_LeavesNothing) {
    writeZip({"a.png", "b.png"});
    EXPECT_NE(refused({.bytes = 12}).find("larger than it may be"), std::string::npos);
    EXPECT_NE(refused({.fileBytes = 7}).find("larger than it may be"), std::string::npos);
    EXPECT_NE(refused({.files = 1}).find("it holds 2 files"), std::string::npos);
    EXPECT_TRUE(!fs::exists(out()) || fs::is_empty(out()));
}

TEST_F(PresetBundle, AnotherFile_IsAnError) {
    writeFile(file(), "no zip file at all");
    EXPECT_EQ(refused(), "it is no zip file");
    EXPECT_FALSE(fs::exists(out() / "set"));
}

TEST_F(PresetBundle, ImportedTwice_LiesInTwoFolders) {
    writeZip({"a.png"});
    ASSERT_TRUE(importBundle(file(), out()));
    const auto second = importBundle(file(), out());
    ASSERT_TRUE(second);
    EXPECT_EQ(second->folder, out() / "set-2");
}

} // namespace
} // namespace patina::preset_bundle_test
