// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>
#include <thread>

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/atomic_file.h"
#include "support/full_disk.h"
#include "support/program.h"

namespace patina::atomic_file_test {
namespace {

namespace fs = std::filesystem;
using tests::FullDisk;
using tests::readFile;
using tests::TemporaryFolder;
using tests::writeFile;

std::size_t filesIn(const fs::path& folder) {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

class AtomicFile : public testing::Test {
  protected:
    AtomicFile() { writeFile(file_, "old"); }

    TemporaryFolder folder_;
    fs::path file_ = folder_ / "a.json";
};

TEST_F(AtomicFile, NewName_IsWritten) {
    ASSERT_TRUE(writeFileAtomically(folder_ / "b.json", "new"));
    EXPECT_EQ(readFile(folder_ / "b.json"), "new");
}

TEST_F(AtomicFile, OldFile_IsReplaced) {
    ASSERT_TRUE(writeFileAtomically(file_, "new"));
    EXPECT_EQ(readFile(file_), "new");
}

TEST_F(AtomicFile, Success_LeavesNoOtherFile) {
    ASSERT_TRUE(writeFileAtomically(file_, "new"));
    EXPECT_EQ(filesIn(folder_.path()), 1u);
}

TEST_F(AtomicFile, Permissions_AreKept) {
    fs::permissions(file_, fs::perms(0640));
    ASSERT_TRUE(writeFileAtomically(file_, "new"));
    EXPECT_EQ(fs::status(file_).permissions(), fs::perms(0640));
}

TEST_F(AtomicFile, NewFile_FollowsTheUsersMask) {
    const mode_t before = ::umask(027);
    ASSERT_TRUE(writeFileAtomically(folder_ / "b.json", "new"));
    ::umask(before);
    EXPECT_EQ(fs::status(folder_ / "b.json").permissions(), fs::perms(0640));
}

TEST_F(AtomicFile, Link_StaysALinkToTheNewContent) {
    fs::create_symlink("a.json", folder_ / "link.json");
    ASSERT_TRUE(writeFileAtomically(folder_ / "link.json", "new"));
    EXPECT_TRUE(fs::is_symlink(folder_ / "link.json"));
    EXPECT_EQ(readFile(file_), "new");
}

TEST_F(AtomicFile, RelativePath_IsWritten) {
    const fs::path before = fs::current_path();
    fs::current_path(folder_.path());
    const auto result = writeFileAtomically("b.json", "new");
    fs::current_path(before);
    EXPECT_TRUE(result);
    EXPECT_EQ(readFile(folder_ / "b.json"), "new");
}

TEST_F(AtomicFile, LongestName_IsWritten) {
    const fs::path file = folder_ / (std::string(250, 'n').append(".json"));
    EXPECT_TRUE(writeFileAtomically(file, "new"));
}

TEST_F(AtomicFile, Folder_IsRefused) {
    EXPECT_EQ(writeFileAtomically(folder_.path(), "new").error().problem, "this is a folder");
}

TEST_F(AtomicFile, MissingFolder_IsAnErrorThatNamesTheFile) {
    const fs::path file = folder_ / "gone/a.json";
    EXPECT_EQ(writeFileAtomically(file, "new").error().file, file.string());
}

TEST_F(AtomicFile, FullDisk_IsAnError) {
    const FullDisk full(4096);
    const auto result = writeFileAtomically(file_, std::string(10'000, 'n'));
    ASSERT_FALSE(result);
    EXPECT_NE(result.error().problem.find("the old file is unchanged"), std::string::npos);
}

TEST_F(AtomicFile, FullDisk_LeavesTheOldFile) {
    const FullDisk full(4096);
    ASSERT_FALSE(writeFileAtomically(file_, std::string(10'000, 'n')));
    EXPECT_EQ(readFile(file_), "old");
}

TEST_F(AtomicFile, FullDisk_LeavesNoOtherFile) {
    const FullDisk full(4096);
    ASSERT_FALSE(writeFileAtomically(file_, std::string(10'000, 'n')));
    EXPECT_EQ(filesIn(folder_.path()), 1u);
}

TEST_F(AtomicFile, Device_IsWrittenToAndStaysADevice) {
    EXPECT_TRUE(writeFileAtomically("/dev/null", "new"));
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(AtomicFile, FullDevice_IsAnError) {
    EXPECT_NE(writeFileAtomically("/dev/full", "new").error().problem.find("No space left"),
              std::string::npos);
}

/// Tries to save as somebody who is not allowed everything, says why it failed and ends.
[[noreturn]] void saveWithoutPrivilege(const fs::path& file) {
    constexpr uid_t nobody = 65534;
    if (::geteuid() == 0 && (::setgid(nobody) != 0 || ::setuid(nobody) != 0)) {
        std::exit(2);
    }
    const auto result = writeFileAtomically(file, "new");
    std::cerr << (result ? "written" : result.error().text());
    std::exit(result ? 0 : 1);
}

TEST_F(AtomicFile, ReadOnlyFolder_IsAnErrorAndTheOldFileStays) {
    fs::permissions(file_, fs::perms(0666));
    fs::permissions(folder_.path(), fs::perms(0555));
    EXPECT_EXIT(saveWithoutPrivilege(file_), testing::ExitedWithCode(1),
                "cannot be saved in its folder: Permission denied");
    fs::permissions(folder_.path(), fs::perms(0755));
    EXPECT_EQ(readFile(file_), "old");
    EXPECT_EQ(filesIn(folder_.path()), 1u);
}

TEST_F(AtomicFile, WriteProtectedFile_IsAnErrorAndStays) {
    fs::permissions(file_, fs::perms(0444));
    fs::permissions(folder_.path(), fs::perms(0777));
    EXPECT_EXIT(saveWithoutPrivilege(file_), testing::ExitedWithCode(1), "is write-protected");
    EXPECT_EQ(readFile(file_), "old");
}

TEST_F(AtomicFile, TwoWritersAtOnce_LeaveOneOfTheirTexts) {
    const std::string first(100'000, '1');
    const std::string second(100'000, '2');
    std::thread other([&] {
        for (int i = 0; i < 20; ++i) {
            ASSERT_TRUE(writeFileAtomically(file_, second));
        }
    });
    for (int i = 0; i < 20; ++i) {
        ASSERT_TRUE(writeFileAtomically(file_, first));
    }
    other.join();
    const std::string left = readFile(file_);
    EXPECT_TRUE(left == first || left == second);
}

} // namespace
} // namespace patina::atomic_file_test
