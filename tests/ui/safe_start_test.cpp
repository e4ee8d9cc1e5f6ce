// SPDX-License-Identifier: GPL-3.0-or-later
// A start after a crash, or with Shift held, can leave out what may be at fault.
#include <sys/wait.h>
#include <unistd.h>

#include <QApplication>
#include <QPushButton>
#include <QTest>
#include <QTimer>

#include <gtest/gtest.h>

#include "support/program.h"
#include "window/safe_start.h"

namespace patina::tests::safe_start_test {
namespace {

/// Starts a program that marks a folder and is gone without putting that in order.
void crash(const std::filesystem::path& folder) {
    const int child = fork();
    if (child == 0) {
        new StartMark(folder);
        _exit(0);
    }
    waitpid(child, nullptr, 0);
}

TEST(StartMark, OfAProgramThatIsGone_IsACrashOnce) {
    const TemporaryFolder folder;
    crash(folder.path());
    EXPECT_TRUE(StartMark(folder.path()).foundCrash());
    EXPECT_FALSE(StartMark(folder.path()).foundCrash());
}

TEST(StartMark, OfAProgramThatRuns_IsNoCrash) {
    const TemporaryFolder folder;
    const StartMark running(folder.path());
    EXPECT_FALSE(StartMark(folder.path()).foundCrash());
    crash(folder.path());
    EXPECT_TRUE(StartMark(folder.path()).foundCrash());
}

TEST(StartMark, PipeAmongThem_IsNoneAndIsNotWaitedFor) {
    const TemporaryFolder folder;
    ASSERT_EQ(::mkfifo((folder.path() / "running-pipe").c_str(), 0600), 0);
    EXPECT_FALSE(StartMark(folder.path()).foundCrash());
}

TEST(StartMark, OfOneThatEndsInOrder_Goes) {
    const TemporaryFolder folder;
    {
        const StartMark mark(folder.path());
        EXPECT_FALSE(std::filesystem::is_empty(folder.path()));
    }
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

/// Clicks a button of the question while it is open.
bool answered(SafeStartReason reason, const QString& button) {
    QTimer::singleShot(100, [button] {
        for (QWidget* widget : QApplication::topLevelWidgets()) {
            const auto buttons = widget->findChildren<QPushButton*>();
            const auto found = std::ranges::find(buttons, button, &QPushButton::text);
            if (widget->objectName() == "safeStart" && found != buttons.end()) {
                QTest::mouseClick(*found, Qt::LeftButton);
            }
        }
    });
    return offerSafeStart(reason);
}

TEST(SafeStart, Question_IsAnsweredByItsButtons) {
    EXPECT_TRUE(answered(SafeStartReason::Crash, "Start Without Them"));
    EXPECT_FALSE(answered(SafeStartReason::ShiftHeld, "Start as Usual"));
}

TEST(SafeStart, WithoutAReason_AsksNothing) {
    EXPECT_FALSE(offerSafeStart(SafeStartReason::None));
}

} // namespace
} // namespace patina::tests::safe_start_test
