// SPDX-License-Identifier: GPL-3.0-or-later
// Answers that must not be believed, and processes that stop or never answer.

#include <gtest/gtest.h>

#include "fake_program.h"
#include "mesh_files.h"

namespace patina::tests::lying_process_test {
namespace {

LoadedMesh load(AssetClient& client) {
    const TemporaryFolder folder;
    writeFile(folder / "any.obj", squareObj);
    return client.loadMesh({folder / "any.obj"});
}

class Lie : public testing::TestWithParam<const char*> {};

TEST_P(Lie, AboutAMesh_IsRefusedAndNamesTheFile) {
    const FakeProgram fake(GetParam());
    AssetClient client(FakeProgram::options());
    const auto mesh = load(client);
    ASSERT_FALSE(mesh);
    EXPECT_NE(mesh.error().text().find("any.obj: the files process gave a wrong answer while"),
              std::string::npos)
        << mesh.error().text();
}

TEST_P(Lie, Once_DoesNotSpoilTheNextRequest) {
    AssetClient client(FakeProgram::options());
    {
        const FakeProgram fake(GetParam());
        ASSERT_FALSE(load(client));
    }
    const auto mesh = load(client); // a new process, which behaves
    EXPECT_TRUE(mesh) << mesh.error().text();
}

INSTANTIATE_TEST_SUITE_P(OfEveryKind, Lie,
                         testing::Values("noise", "wrong kind", "no block", "unsealed block",
                                         "another kind of block", "short block", "wrong magic",
                                         "huge vertex count", "huge index count",
                                         "more vertices than bytes", "index beyond the vertices",
                                         "position that is not finite"),
                         [](const auto& information) {
                             std::string name = information.param;
                             std::erase(name, ' ');
                             return name;
                         });

TEST(LyingProcess, AboutAnImage_IsRefused) {
    const FakeProgram fake("another kind of block");
    const TemporaryFolder folder;
    writeFile(folder / "any.png", "x");
    AssetClient client(FakeProgram::options());
    EXPECT_FALSE(client.loadImage(folder / "any.png"));
}

TEST(LyingProcess, ProgressThatIsNoNumber_IsIgnored) {
    const FakeProgram fake("progress of nan");
    const TemporaryFolder folder;
    writeFile(folder / "any.obj", squareObj);
    AssetClient client(FakeProgram::options());
    Progress progress;
    ASSERT_TRUE(client.loadMesh({folder / "any.obj"}, &progress));
    EXPECT_EQ(progress.done, 1.0f);
}

TEST(CrashingProcess, WhileReading_IsAMessage) {
    const FakeProgram fake("crash");
    AssetClient client(FakeProgram::options());
    const auto mesh = load(client);
    ASSERT_FALSE(mesh);
    EXPECT_EQ(mesh.error().problem, "the files process stopped unexpectedly while reading");
}

TEST(CrashingProcess, Once_DoesNotSpoilTheNextRequest) {
    AssetClient client(FakeProgram::options());
    {
        const FakeProgram fake("crash");
        ASSERT_FALSE(load(client));
    }
    EXPECT_TRUE(load(client));
}

TEST(CrashingProcess, BeforeTheRequest_IsAMessage) {
    const FakeProgram fake("exit at once");
    AssetClient client(FakeProgram::options());
    const auto mesh = load(client);
    ASSERT_FALSE(mesh);
    EXPECT_NE(mesh.error().problem.find("stopped unexpectedly"), std::string::npos);
}

TEST(HangingProcess, PastTheTimeLimit_IsEndedWithAMessage) {
    const FakeProgram fake("hang");
    AssetClient client(FakeProgram::options(0.2));
    const auto mesh = load(client);
    ASSERT_FALSE(mesh);
    EXPECT_EQ(mesh.error().problem, "stopped after 0.2 seconds of reading");
}

TEST(WorkingProcess, PastTheLimitOfItsWork_IsEndedWithAMessage) {
    const FakeProgram fake("spin");
    AssetClient::Options options = FakeProgram::options();
    options.timeLimitSeconds = 0.2;
    AssetClient client(options);
    const auto mesh = load(client);
    ASSERT_FALSE(mesh);
    EXPECT_EQ(mesh.error().problem, "stopped after 0.2 seconds of reading");
}

TEST(WorkingProcess, WithoutAProcessorForLongerThanThat_MayFinish) {
    const FakeProgram fake("sleep");
    AssetClient::Options options = FakeProgram::options();
    options.timeLimitSeconds = 0.2;
    AssetClient client(options);
    const auto mesh = load(client);
    EXPECT_TRUE(mesh) << mesh.error().text();
}

TEST(HangingProcess, Once_DoesNotSpoilTheNextRequest) {
    AssetClient client(FakeProgram::options(0.5));
    {
        const FakeProgram fake("hang");
        ASSERT_FALSE(load(client));
    }
    EXPECT_TRUE(load(client));
}

TEST(MissingProgram, IsAMessage) {
    AssetClient::Options options;
    options.program = "/nowhere/patina-files";
    AssetClient client(options);
    const auto mesh = load(client);
    ASSERT_FALSE(mesh);
    EXPECT_NE(mesh.error().problem.find("cannot start /nowhere/patina-files"), std::string::npos);
}

} // namespace
} // namespace patina::tests::lying_process_test
