// SPDX-License-Identifier: GPL-3.0-or-later
// What takes long, in one list: who reports to it, what is shown, and how it is stopped.
#include <future>

#include <QPointer>
#include <QProgressBar>
#include <QSignalSpy>
#include <QTest>
#include <QThread>
#include <QToolButton>
#include <gtest/gtest.h>

#include "background/worker.h"
#include "window/task_popup.h"

namespace patina::tests::long_tasks_test {
namespace {

constexpr int waitMs = 20000;

/// The row of the program's list that has a name; null: there is none.
std::optional<LongTasks::Row> rowCalled(const QString& name) {
    const std::vector<LongTasks::Row> rows = LongTasks::all().running();
    const auto found = std::ranges::find(rows, name, &LongTasks::Row::name);
    return found == rows.end() ? std::nullopt : std::optional(*found);
}

const auto nothing = [](const Result<int>&) {};

TEST(LongTasks, WhatEndsSoon_IsNotShown) {
    LongTasks tasks;
    QSignalSpy changed(&tasks, &LongTasks::changed);
    const quint64 number = tasks.begin({"Quick"});
    EXPECT_EQ(tasks.running().size(), 1u);
    EXPECT_TRUE(tasks.shown().empty());
    tasks.end(number);
    EXPECT_TRUE(tasks.running().empty());
    EXPECT_TRUE(changed.isEmpty());
}

TEST(LongTasks, WhatGoesOn_IsShownWithItsStateUntilItEnds) {
    LongTasks tasks;
    QSignalSpy changed(&tasks, &LongTasks::changed);
    const quint64 number = tasks.begin({"Long", [] { return TaskState{0.5, "this"}; }});
    ASSERT_TRUE(changed.wait(waitMs));
    ASSERT_EQ(tasks.shown().size(), 1u);
    EXPECT_EQ(tasks.shown()[0].name, "Long");
    EXPECT_EQ(tasks.shown()[0].state.share, 0.5);
    EXPECT_EQ(tasks.shown()[0].state.doing, "this");
    EXPECT_FALSE(tasks.shown()[0].canCancel);
    changed.clear();
    tasks.end(number);
    EXPECT_EQ(changed.count(), 1);
    EXPECT_TRUE(tasks.shown().empty());
}

TEST(LongTasks, Worker_IsListedUntilAllThatWasAskedForIsHandedOver) {
    std::promise<void> gate;
    Worker worker({.name = "Named work"});
    worker.ask(
        [open = gate.get_future().share()](Worker::Control&) {
            open.wait();
            return 1;
        },
        nothing, {}, "first.obj");
    worker.ask([](Worker::Control&) { return 2; }, nothing, {}, "second.obj");
    const auto isFirst = [] { return rowCalled("Named work")->state.doing.startsWith("first"); };
    ASSERT_TRUE(rowCalled("Named work"));
    EXPECT_TRUE(QTest::qWaitFor(isFirst, waitMs));
    EXPECT_FALSE(rowCalled("Named work")->canCancel);
    gate.set_value();
    ASSERT_TRUE(QTest::qWaitFor([&] { return worker.isIdle(); }, waitMs));
    EXPECT_FALSE(rowCalled("Named work"));
}

TEST(LongTasks, WorkerWithoutAName_IsNotListed) {
    Worker worker;
    const std::size_t before = LongTasks::all().running().size();
    worker.ask([](Worker::Control&) { return 1; }, nothing);
    EXPECT_EQ(LongTasks::all().running().size(), before);
}

TEST(LongTasks, Cancel_StopsTheWorker) {
    Worker worker({.name = "Endless work", .canCancel = true});
    worker.ask(
        [](const Worker::Control& control) {
            while (!control.isCancelled()) {
                QThread::msleep(1);
            }
            return 1;
        },
        nothing);
    ASSERT_TRUE(rowCalled("Endless work"));
    LongTasks::all().cancel(rowCalled("Endless work")->number);
    EXPECT_TRUE(QTest::qWaitFor([&] { return worker.isIdle(); }, waitMs));
}

TEST(LongTasks, DestroyedWorker_IsNotListed) {
    {
        Worker worker({.name = "Dropped work"});
        worker.ask([](Worker::Control&) { return 1; }, nothing);
        EXPECT_TRUE(rowCalled("Dropped work"));
    }
    EXPECT_FALSE(rowCalled("Dropped work"));
}

TEST(TaskPopup, Lines_FollowTheTasksAndTheLastOneTakesItAway) {
    LongTasks tasks;
    QSignalSpy changed(&tasks, &LongTasks::changed);
    bool isStopped = false;
    const quint64 first = tasks.begin({"First",
                                       [] {
                                           return TaskState{0.25, {}};
                                       },
                                       [&] { isStopped = true; }});
    const quint64 second = tasks.begin({"Second"});
    ASSERT_TRUE(QTest::qWaitFor([&] { return tasks.shown().size() == 2; }, waitMs));
    const QPointer popup = new TaskPopup(tasks, nullptr);
    popup->showAt({500, 500});
    ASSERT_EQ(popup->findChildren<QProgressBar*>().size(), 2);
    EXPECT_EQ(popup->findChildren<QProgressBar*>()[0]->value(), 25);
    EXPECT_FALSE(popup->findChildren<QProgressBar*>()[1]->isVisible());
    popup->findChildren<QToolButton*>()[0]->click();
    EXPECT_TRUE(isStopped);
    tasks.end(first);
    tasks.end(second);
    EXPECT_TRUE(QTest::qWaitFor([&] { return !popup; }, waitMs));
}

} // namespace
} // namespace patina::tests::long_tasks_test
