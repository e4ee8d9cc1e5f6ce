// SPDX-License-Identifier: GPL-3.0-or-later
// The real files process, ended in the middle of its work.
#include <chrono>
#include <csignal>
#include <filesystem>
#include <future>
#include <string>

#include <gtest/gtest.h>
#include <sys/wait.h>

#include "child_processes.h"
#include "mesh_files.h"

namespace patina::tests::killed_process_test {
namespace {

using namespace std::chrono_literals;

/// An OBJ file that takes a good part of a second to read.
std::string largeObj() {
    constexpr int side = 600;
    std::string text;
    for (int i = 0; i < side * side; ++i) {
        text += "v " + std::to_string(i % side) + " " + std::to_string(i / side) + " " +
                std::to_string(i % 13) + "\n";
    }
    for (int i = 0; i + side + 1 < side * side; ++i) {
        text += "f " + std::to_string(i + 1) + " " + std::to_string(i + 2) + " " +
                std::to_string(i + side + 2) + "\n";
    }
    return text;
}

class LargeImport : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        folder_ = new TemporaryFolder;
        writeFile(file(), largeObj());
    }
    static void TearDownTestSuite() {
        delete folder_;
        folder_ = nullptr;
    }
    static std::filesystem::path file() { return *folder_ / "large.obj"; }

    std::future<LoadedMesh> start() {
        return std::async(std::launch::async,
                          [this] { return client_.loadMesh({file()}, &progress_); });
    }

    /// The process that has begun to read.
    static pid_t readingProcess() {
        EXPECT_TRUE(eventually([] { return childOf(::getpid()).has_value(); }));
        std::this_thread::sleep_for(30ms);
        return childOf(::getpid()).value_or(0);
    }

    AssetClient client_;
    Progress progress_;

  private:
    static inline TemporaryFolder* folder_ = nullptr;
};

TEST_F(LargeImport, KilledHalfWay_IsAMessageAndTheNextImportWorks) {
    auto import = start();
    const pid_t process = readingProcess();
    ASSERT_GT(process, 0);
    ::kill(process, SIGKILL);
    const auto mesh = import.get();
    ASSERT_FALSE(mesh);
    EXPECT_EQ(mesh.error().problem, "the files process stopped unexpectedly while reading");
    const auto next = client_.loadMesh({file()});
    EXPECT_TRUE(next) << next.error().text();
}

TEST_F(LargeImport, CancelledHalfWay_EndsTheProcessWithinAMoment) {
    auto import = start();
    const pid_t process = readingProcess();
    const auto before = std::chrono::steady_clock::now();
    progress_.cancelled = true;
    const auto mesh = import.get();
    EXPECT_LT(std::chrono::steady_clock::now() - before,
              500ms); // polled every 20 ms; slow machines
    ASSERT_FALSE(mesh);
    EXPECT_EQ(mesh.error().problem, "cancelled while reading");
    EXPECT_FALSE(isAlive(process));
}

TEST_F(LargeImport, CancelledHalfWay_LeavesTheNextImportWorking) {
    auto import = start();
    readingProcess();
    progress_.cancelled = true;
    ASSERT_FALSE(import.get());
    const auto next = client_.loadMesh({file()});
    EXPECT_TRUE(next) << next.error().text();
}

TEST_F(LargeImport, CancelledWhileAnotherRuns_DoesNotWaitForIt) {
    auto first = start();
    readingProcess();
    Progress second;
    second.cancelled = true;
    const auto mesh = client_.loadMesh({file()}, &second);
    ASSERT_FALSE(mesh);
    EXPECT_EQ(mesh.error().problem, "cancelled before it began");
    EXPECT_TRUE(first.get());
}

TEST_F(LargeImport, Finished_HasReportedProgressToTheEnd) {
    ASSERT_TRUE(start().get());
    EXPECT_EQ(progress_.done, 1.0f);
}

TEST_F(LargeImport, Killed_LeavesNothingInSharedMemory) {
    const auto count = [] {
        return std::distance(std::filesystem::directory_iterator("/dev/shm"), {});
    };
    const auto before = count();
    auto import = start();
    ::kill(readingProcess(), SIGKILL);
    ASSERT_FALSE(import.get());
    EXPECT_EQ(count(), before);
}

TEST_F(LargeImport, WhoseClientIsKilled_EndsToo) {
    const pid_t parent = ::fork();
    if (parent == 0) {
        AssetClient client;
        [[maybe_unused]] const auto mesh = client.loadMesh({file()});
        ::pause();
    }
    ASSERT_TRUE(eventually([&] { return childOf(parent).has_value(); }));
    const pid_t process = *childOf(parent);
    ::kill(parent, SIGKILL);
    ::waitpid(parent, nullptr, 0);
    EXPECT_TRUE(eventually([&] { return !isAlive(process); }));
}

TEST(WarmProcess, KilledBetweenRequests_IsReplacedWithoutAMessage) {
    const TemporaryFolder folder;
    writeFile(folder / "square.obj", squareObj);
    AssetClient client;
    ASSERT_TRUE(client.loadMesh({folder / "square.obj"}));
    const pid_t process = childOf(::getpid()).value_or(0);
    ASSERT_GT(process, 0);
    ::kill(process, SIGKILL);
    ASSERT_TRUE(eventually([&] { return !isAlive(process); }));
    const auto mesh = client.loadMesh({folder / "square.obj"});
    EXPECT_TRUE(mesh) << mesh.error().text();
}

TEST(WarmProcess, SecondRequest_IsAnsweredByTheSameProcess) {
    const TemporaryFolder folder;
    writeFile(folder / "square.obj", squareObj);
    AssetClient client;
    ASSERT_TRUE(client.loadMesh({folder / "square.obj"}));
    const auto first = childOf(::getpid());
    ASSERT_TRUE(client.loadMesh({folder / "square.obj"}));
    EXPECT_EQ(childOf(::getpid()), first);
}

TEST(Client, Destroyed_LeavesNoProcess) {
    {
        AssetClient client;
        client.warmUp();
        ASSERT_TRUE(eventually([] { return childOf(::getpid()).has_value(); }));
    }
    EXPECT_FALSE(childOf(::getpid()));
}

TEST(SharedMesh, OutlivesItsClient) {
    const auto mesh = loaded("square.obj", squareObj); // the client is gone already
    ASSERT_TRUE(mesh);
    EXPECT_EQ((*mesh)->view().bounds.upper, glm::vec3(1.0f, 1.0f, 0.0f));
}

} // namespace
} // namespace patina::tests::killed_process_test
