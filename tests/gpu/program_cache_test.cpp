// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/effect_set.h"
#include "shading/effects/surface_program.h"
#include "shading/program/program_cache.h"

#include <filesystem>

#include "gpu_fixture.h"
#include "shading/program/program_file.h"
#include "support/program.h"

namespace patina::program_cache_test {
namespace {

using tests::readFile;
using tests::TemporaryFolder;
using tests::writeFile;

class ProgramCacheTest : public GpuTest {
  protected:
    ProgramSource phong() const {
        const Scene scene = simpleScene("phong");
        return *surfaceProgram(effectSet(scene.objects[0].material, scene, *catalog), *catalog);
    }

    /// The one file in the folder after a first start.
    std::filesystem::path storedFile() const {
        ProgramCache first(folder_.path());
        first.get(phong());
        auto file = ProgramFile(folder_.path(), phong().hash()).path();
        EXPECT_TRUE(std::filesystem::exists(file));
        return file;
    }

    bool nextStartCompiles() const {
        ProgramCache next(folder_.path());
        return next.get(phong()).compiled;
    }

    TemporaryFolder folder_;
};

TEST_F(ProgramCacheTest, SecondTime_ComesFromMemory) {
    ProgramCache cache({});
    EXPECT_TRUE(cache.get(phong()).compiled);
    EXPECT_FALSE(cache.get(phong()).compiled);
}

TEST_F(ProgramCacheTest, NextStart_ComesFromDisk) {
    storedFile();
    EXPECT_FALSE(nextStartCompiles());
}

TEST_F(ProgramCacheTest, TruncatedFile_IsCompiledAgain) {
    const auto file = storedFile();
    std::filesystem::resize_file(file, std::filesystem::file_size(file) / 2);
    EXPECT_TRUE(nextStartCompiles());
}

TEST_F(ProgramCacheTest, EmptyFile_IsCompiledAgain) {
    std::filesystem::resize_file(storedFile(), 0);
    EXPECT_TRUE(nextStartCompiles());
}

TEST_F(ProgramCacheTest, DamagedByte_IsCompiledAgain) {
    const auto file = storedFile();
    std::string content = readFile(file);
    content[content.size() - 10] = static_cast<char>(content[content.size() - 10] ^ 0x40);
    writeFile(file, content);
    EXPECT_TRUE(nextStartCompiles());
}

TEST_F(ProgramCacheTest, OtherDriversFile_IsCompiledAgain) {
    const auto file = storedFile();
    std::string content = readFile(file);
    content.replace(content.find(" on "), 4, " On ");
    writeFile(file, content);
    EXPECT_TRUE(nextStartCompiles());
}

TEST_F(ProgramCacheTest, DamagedFile_IsReplaced) {
    std::filesystem::resize_file(storedFile(), 100);
    EXPECT_TRUE(nextStartCompiles());
    EXPECT_FALSE(nextStartCompiles());
}

TEST_F(ProgramCacheTest, FolderThatCannotBeMade_StillGivesAProgram) {
    writeFile(folder_ / "file", "in the way");
    ProgramCache cache(folder_ / "file");
    EXPECT_NE(cache.get(phong()).program, nullptr);
}

TEST_F(ProgramCacheTest, BrokenSource_IsCompiledOnce) {
    ProgramSource broken = phong();
    broken.fragment.text += "nonsense\n";
    ProgramCache cache({});
    EXPECT_FALSE(cache.get(broken).errors.empty());
    cache.get(broken);
    EXPECT_EQ(cache.compiledCount(), 1);
}

} // namespace
} // namespace patina::program_cache_test
