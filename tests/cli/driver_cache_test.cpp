// SPDX-License-Identifier: GPL-3.0-or-later
// The index of Mesa's cache has its room on the disk, or there is no cache.
#include <algorithm>

#include <gtest/gtest.h>

#include <sys/mount.h>
#include <sys/stat.h>

#include "cli/patina_program.h"
#include "gl/driver_cache.h"

namespace patina::tests::driver_cache_test {
namespace {

std::size_t bytesOnDisk(const std::filesystem::path& file) {
    struct stat status {};
    return ::stat(file.c_str(), &status) == 0 ? std::size_t(status.st_blocks) * 512 : 0;
}

TEST(DriverCache, Index_HasItsRoomBeforeItIsMapped) {
    const TemporaryFolder folder;
    ASSERT_TRUE(gl::reserveCacheIndex(folder / "mesa_shader_cache"));
    EXPECT_GE(bytesOnDisk(folder / "mesa_shader_cache/index"), 8u + 65536u * 20u);
}

TEST(DriverCache, SparseIndexOfBefore_GetsItsRoomAndKeepsItsContent) {
    const TemporaryFolder folder;
    writeFile(folder / "index", "counted");
    std::filesystem::resize_file(folder / "index", 8 + 65536 * 20);
    ASSERT_LT(bytesOnDisk(folder / "index"), 100'000u);
    ASSERT_TRUE(gl::reserveCacheIndex(folder.path()));
    EXPECT_GE(bytesOnDisk(folder / "index"), 8u + 65536u * 20u);
    EXPECT_TRUE(readFile(folder / "index").starts_with("counted"));
}

TEST(DriverCache, FolderThatCannotBe_IsTold) {
    const TemporaryFolder folder;
    writeFile(folder / "file", "");
    const auto reserved = gl::reserveCacheIndex(folder / "file/mesa_shader_cache");
    ASSERT_FALSE(reserved);
    EXPECT_NE(reserved.error().text().find("keeps no programs here"), std::string::npos);
}

// A file may be no longer than 400 KiB, as on a disk that has no more.
TEST(DriverCache, NoRoomForTheIndex_IsToldOnceAndThePictureIsDrawn) {
    const TemporaryFolder disk;
    Start start;
    start.arguments = {"-c", "ulimit -f 400 && exec " + patinaProgram().string() + " render " +
                                 gold + " --size 16x16 -o -"};
    start.environment = {{"MESA_SHADER_CACHE_DIR", disk.path()},
                         {"XDG_CACHE_HOME", disk.path()},
                         {"DISPLAY", ""},
                         {"WAYLAND_DISPLAY", ""}};
    const Outcome outcome = run("/bin/bash", start);
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_TRUE(outcome.out.starts_with("\x89PNG"));
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_NE(outcome.err.find("keeps no programs here"), std::string::npos) << outcome.err;
}

} // namespace
} // namespace patina::tests::driver_cache_test
