// SPDX-License-Identifier: GPL-3.0-or-later
// Files, and what only looks like one.
#include "core/ordinary_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include "support/program.h"

namespace patina::ordinary_file_test {
namespace {

using tests::TemporaryFolder;

std::string complaintAbout(const std::filesystem::path& file, std::uintmax_t maxBytes = 100) {
    const auto content = readFile(file, maxBytes);
    return content ? "it was read" : content.error().problem;
}

void makeSocket(const std::filesystem::path& file) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    file.string().copy(address.sun_path, sizeof address.sun_path - 1);
    const int descriptor = ::socket(AF_UNIX, SOCK_STREAM, 0);
    ASSERT_EQ(0, ::bind(descriptor, reinterpret_cast<const sockaddr*>(&address), sizeof address));
    ::close(descriptor);
}

TEST(OrdinaryFile, Content_IsRead) {
    const TemporaryFolder folder;
    tests::writeFile(folder / "a", "hello");
    EXPECT_EQ(readFile(folder / "a", 5), "hello");
}

TEST(OrdinaryFile, EmptyFile_IsRead) {
    const TemporaryFolder folder;
    tests::writeFile(folder / "a", "");
    EXPECT_EQ(readFile(folder / "a", 5), "");
}

TEST(OrdinaryFile, LinkToAFile_IsFollowed) {
    const TemporaryFolder folder;
    tests::writeFile(folder / "a", "hello");
    std::filesystem::create_symlink("a", folder / "b");
    EXPECT_EQ(readFile(folder / "b", 100), "hello");
}

TEST(OrdinaryFile, Missing_IsNamed) {
    EXPECT_EQ(readFile("/nowhere/a", 100).error().text(), "/nowhere/a: no such file");
}

TEST(OrdinaryFile, LargerThanItsLimit_IsRefusedWithTheLimit) {
    const TemporaryFolder folder;
    tests::writeFile(folder / "a", "hello");
    EXPECT_EQ(complaintAbout(folder / "a", 4), "is larger than 4 bytes");
}

TEST(OrdinaryFile, SparseFileOfTenGigabytes_IsNotRead) {
    const TemporaryFolder folder;
    tests::writeFile(folder / "a", "");
    std::filesystem::resize_file(folder / "a", std::uintmax_t(10) << 30);
    EXPECT_EQ(complaintAbout(folder / "a", maxAssetBytes), "is larger than 1 GiB");
}

TEST(OrdinaryFile, FileThatGrew_IsReadToItsLimitOnly) {
    const TemporaryFolder folder;
    tests::writeFile(folder / "a", "hello");
    const auto opened = OrdinaryFile::open(folder / "a", 8);
    tests::writeFile(folder / "a", "hello hello");
    EXPECT_EQ(opened->content().error().problem, "is larger than 8 bytes");
}

/// The system makes it up while it is read; its size is 0.
TEST(OrdinaryFile, FileWithoutASize_IsReadToItsEnd) {
    const auto content = readFile("/proc/self/status", 1u << 20);
    ASSERT_TRUE(content) << content.error().text();
    EXPECT_TRUE(content->starts_with("Name:"));
}

TEST(OrdinaryFile, NoOrdinaryOne_IsRefusedWithoutWaiting) {
    const TemporaryFolder folder;
    ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
    makeSocket(folder / "socket");
    EXPECT_EQ(complaintAbout(folder.path()), "is a folder");
    EXPECT_EQ(complaintAbout(folder / "pipe"), "is a pipe");
    EXPECT_EQ(complaintAbout(folder / "socket"), "is a socket");
    EXPECT_EQ(complaintAbout("/dev/ptmx"), "is a device");
    EXPECT_EQ(complaintAbout("/dev/zero"), "is a device");
}

/// What openBelow() says of a path from a folder.
class FileBelow : public testing::Test {
  protected:
    FileBelow() {
        std::filesystem::create_directories(folder_ / "home/maps");
        tests::writeFile(folder_ / "secret", "secret");
        tests::writeFile(folder_ / "home/a", "hello");
        tests::writeFile(folder_ / "home/maps/b", "hello");
        handle_ = ::open((folder_ / "home").c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC);
    }
    void TearDown() override { ::close(handle_); }

    std::string read(const std::filesystem::path& path) const {
        const auto content =
            OrdinaryFile::openBelow(handle_, path, 100).and_then([](const OrdinaryFile& file) {
                return file.content();
            });
        return content ? *content : content.error().problem;
    }
    std::string readLink(const std::filesystem::path& target) const {
        std::filesystem::create_symlink(target, folder_ / "home/link");
        return read("link");
    }

    static constexpr const char* refused_ = "lies outside the folder";
    TemporaryFolder folder_;
    int handle_ = -1;
};

TEST_F(FileBelow, InTheFolder_IsRead) {
    EXPECT_EQ(read("a"), "hello");
    EXPECT_EQ(read("maps/b"), "hello");
    EXPECT_EQ(read("maps/../a"), "hello");
}

TEST_F(FileBelow, FullPathIntoTheFolder_IsRead) {
    EXPECT_EQ(read(folder_ / "home/maps/b"), "hello");
}

TEST_F(FileBelow, PathOutOfTheFolder_IsRefused) {
    EXPECT_EQ(read("../secret"), refused_);
    EXPECT_EQ(read("maps/../../secret"), refused_);
    EXPECT_EQ(read(folder_ / "secret"), refused_);
}

TEST_F(FileBelow, PathOutOfTheFolder_IsDecidedOnByWhereItLeads) {
    std::filesystem::create_symlink("../secret", folder_ / "home/link");
    const auto secret = std::filesystem::canonical(folder_ / "secret");
    const auto isSecret = [&](const std::filesystem::path& place) { return place == secret; };
    EXPECT_TRUE(OrdinaryFile::openBelow(handle_, "link", 100, isSecret));
    const auto isLink = [&](const std::filesystem::path& place) {
        return place.filename() == "link";
    };
    EXPECT_FALSE(OrdinaryFile::openBelow(handle_, "link", 100, isLink));
}

TEST_F(FileBelow, FolderThatOnlyBeginsAlike_IsOutside) {
    std::filesystem::create_directory(folder_ / "home2");
    tests::writeFile(folder_ / "home2/a", "secret");
    EXPECT_EQ(read("../home2/a"), refused_);
}

TEST_F(FileBelow, LinkOutOfTheFolder_IsRefused) {
    EXPECT_EQ(readLink("../secret"), refused_);
}

TEST_F(FileBelow, LinkWithinTheFolder_IsFollowed) {
    EXPECT_EQ(readLink(folder_ / "home/maps/b"), "hello");
}

TEST_F(FileBelow, LinkedFolderOutside_IsRefused) {
    std::filesystem::create_symlink("..", folder_ / "home/up");
    EXPECT_EQ(read("up/secret"), refused_);
}

TEST_F(FileBelow, LinkToADevice_IsRefused) {
    EXPECT_EQ(readLink("/dev/ptmx"), refused_);
}

TEST_F(FileBelow, Pipe_IsRefusedWithoutWaiting) {
    ASSERT_EQ(::mkfifo((folder_ / "home/pipe").c_str(), 0600), 0);
    EXPECT_EQ(read("pipe"), "is a pipe");
}

} // namespace
} // namespace patina::ordinary_file_test
