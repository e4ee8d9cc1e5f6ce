// SPDX-License-Identifier: GPL-3.0-or-later
#include <atomic>
#include <future>
#include <stdexcept>
#include <string>
#include <vector>

#include <QTest>
#include <QThread>
#include <gtest/gtest.h>

#include "background/worker.h"
#include "gl/driver.h"

namespace patina::tests::worker_test {
namespace {

constexpr int waitMs = 20000;
constexpr int shortMs = 50;

/// Keeps the worker's thread busy until it is opened.
class Gate {
  public:
    void open() { opened_.set_value(); }

    /// Work that gives back a number when the gate is open.
    auto workFor(int number) {
        return [this, number](Worker::Control&) {
            begun_ = true;
            isOpen_.wait();
            return number;
        };
    }

    bool isBegun() {
        return QTest::qWaitFor([this] { return begun_.load(); }, waitMs);
    }

  private:
    std::promise<void> opened_;
    std::shared_future<void> isOpen_ = opened_.get_future().share();
    std::atomic<bool> begun_ = false;
};

auto workFor(int number) {
    return [number](Worker::Control&) { return number; };
}

/// Work that goes on until it is cancelled, and says so.
auto workUntilCancelled(std::atomic<bool>& begun) {
    return [&begun](const Worker::Control& control) {
        begun = true;
        while (!control.isCancelled()) {
            QThread::msleep(1);
        }
        return 1;
    };
}

class WorkerTest : public ::testing::Test {
  protected:
    /// Takes results into the list.
    auto taken() {
        return [this](const Result<int>& result) { results_.push_back(result.value_or(-1)); };
    }

    static bool comesToRest(const Worker& worker) {
        return QTest::qWaitFor([&] { return worker.isIdle(); }, waitMs);
    }

    const std::vector<int>& results() const { return results_; }

  private:
    std::vector<int> results_; ///< before any worker, whose end comes first
};

TEST_F(WorkerTest, Work_IsDoneBesideTheWindowAndItsResultIsHandedOverThere) {
    Worker worker;
    QThread* handedOver = nullptr;
    QThread* worked = nullptr;
    worker.ask([](Worker::Control&) { return QThread::currentThread(); },
               [&](const Result<QThread*>& result) {
                   worked = *result;
                   handedOver = QThread::currentThread();
               });
    ASSERT_TRUE(comesToRest(worker));
    EXPECT_EQ(handedOver, QThread::currentThread());
    EXPECT_NE(worked, nullptr);
    EXPECT_NE(worked, QThread::currentThread());
}

TEST_F(WorkerTest, Requests_AreDoneInTheOrderInWhichTheyCame) {
    Worker worker;
    for (int i = 0; i < 5; ++i) {
        worker.ask(workFor(i), taken());
    }
    ASSERT_TRUE(comesToRest(worker));
    EXPECT_EQ(results(), (std::vector{0, 1, 2, 3, 4}));
}

TEST_F(WorkerTest, NewestOfAKey_TakesThePlaceOfTheOneThatWaits) {
    Gate gate;
    Worker worker;
    worker.ask(gate.workFor(0), taken(), "key");
    ASSERT_TRUE(gate.isBegun());
    worker.ask(workFor(1), taken(), "key");
    worker.ask(workFor(2), taken(), "other");
    worker.ask(workFor(3), taken());
    worker.ask(workFor(4), taken(), "key");
    gate.open();
    ASSERT_TRUE(comesToRest(worker));
    EXPECT_EQ(results(), (std::vector{0, 4, 2, 3}));
}

TEST_F(WorkerTest, WhatRuns_HearsThatANewerOneOfItsKeyWaits) {
    Worker worker;
    std::atomic<int> looks = 0;
    const auto work = [&looks](const Worker::Control& control) {
        while (!control.isSuperseded()) {
            ++looks;
            QThread::msleep(1);
        }
        return 1;
    };
    worker.ask(work, taken(), "key");
    ASSERT_TRUE(QTest::qWaitFor([&] { return looks > 0; }, waitMs));
    worker.ask(workFor(0), taken(), "other");
    const int before = looks;
    ASSERT_TRUE(QTest::qWaitFor([&] { return looks > before + 1; }, waitMs));
    worker.ask(workFor(2), taken(), "key");
    ASSERT_TRUE(comesToRest(worker));
    EXPECT_EQ(results(), (std::vector{1, 0, 2}));
}

TEST_F(WorkerTest, Exception_IsAnErrorAndTheNextRequestIsDone) {
    Worker worker;
    std::string problem;
    worker.ask([](Worker::Control&) -> int { throw std::runtime_error("no memory"); },
               [&](const Result<int>& result) { problem = result.error().problem; });
    Errors problems;
    worker.ask([](Worker::Control&) -> Checked<int> { throw 1; },
               [&](const Checked<int>& result) { problems = result.error(); });
    worker.ask(workFor(3), taken());
    ASSERT_TRUE(comesToRest(worker));
    EXPECT_EQ(problem, "no memory");
    EXPECT_EQ(problems.size(), 1u);
    EXPECT_EQ(results(), (std::vector{3}));
}

TEST_F(WorkerTest, Cancelled_HandsOverWhatItHas) {
    std::atomic<bool> begun = false;
    Worker worker;
    worker.ask(workUntilCancelled(begun), taken());
    ASSERT_TRUE(QTest::qWaitFor([&] { return begun.load(); }, waitMs));
    worker.cancel();
    ASSERT_TRUE(comesToRest(worker));
    EXPECT_EQ(results(), (std::vector{1}));
}

TEST_F(WorkerTest, Forgotten_HandsNothingOverButWhatIsAskedForAfterwards) {
    std::atomic<bool> begun = false;
    Worker worker;
    worker.ask(workUntilCancelled(begun), taken());
    worker.ask(workFor(2), taken());
    ASSERT_TRUE(QTest::qWaitFor([&] { return begun.load(); }, waitMs));
    worker.forget();
    EXPECT_TRUE(worker.isIdle());
    worker.ask(workFor(3), taken());
    ASSERT_TRUE(comesToRest(worker));
    EXPECT_EQ(results(), (std::vector{3}));
}

TEST_F(WorkerTest, ResultThatIsOnItsWay_CanBeForgotten) {
    Worker worker;
    worker.ask(workFor(1), taken());
    worker.finish();
    worker.forget();
    QCoreApplication::processEvents();
    EXPECT_TRUE(results().empty());
}

TEST_F(WorkerTest, Destroyed_CancelsWhatRunsAndBeginsNothingMore) {
    std::atomic<bool> begun = false;
    std::atomic<bool> isRunning = false;
    std::atomic<bool> isNextBegun = false;
    {
        Worker worker;
        worker.ask(
            [&](const Worker::Control& control) {
                isRunning = true;
                const int done = workUntilCancelled(begun)(control);
                isRunning = false;
                return done;
            },
            taken());
        worker.ask([&](Worker::Control&) { isNextBegun = true; }, [](const Result<void>&) {});
        ASSERT_TRUE(QTest::qWaitFor([&] { return begun.load(); }, waitMs));
    }
    EXPECT_FALSE(isRunning);
    EXPECT_FALSE(isNextBegun);
    QCoreApplication::processEvents();
    EXPECT_TRUE(results().empty());
}

TEST_F(WorkerTest, DestroyedWhereItFinishes_HasDoneAllThatWasAskedFor) {
    std::atomic<int> done = 0;
    {
        Worker worker{{.atEnd = Worker::AtEnd::Finish}};
        for (int i = 0; i < 3; ++i) {
            worker.ask([&](const Worker::Control& control) { done += !control.isCancelled(); },
                       [](const Result<void>&) {});
        }
    }
    EXPECT_EQ(done, 3);
}

TEST_F(WorkerTest, Paused_BeginsNothingBeforeItIsResumed) {
    Worker worker{{.isPaused = true}};
    worker.ask(workFor(1), taken());
    QTest::qWait(shortMs);
    EXPECT_TRUE(results().empty());
    worker.resume();
    ASSERT_TRUE(comesToRest(worker));
    EXPECT_EQ(results(), (std::vector{1}));
}

TEST_F(WorkerTest, News_ComeBeforeTheResultOfTheirWork) {
    Worker worker;
    worker.ask(
        [this](const Worker::Control& control) {
            control.show([this] { taken()(1); });
            return 2;
        },
        taken());
    ASSERT_TRUE(comesToRest(worker));
    EXPECT_EQ(results(), (std::vector{1, 2}));
}

TEST_F(WorkerTest, Context_StaysForTheNextRequestAndIsThereWhenTheThreadRests) {
    std::string found;
    std::string atRest;
    std::promise<void> rests;
    {
        Worker worker{{.atRest =
                           [&] {
                               atRest = gl::driverText();
                               rests.set_value();
                           },
                       .isPaused = true}};
        worker.ask([](const Worker::Control& control) { return control.openContext(); },
                   [](const Result<void>& opened) { EXPECT_TRUE(opened.has_value()); });
        worker.ask([](Worker::Control&) { return gl::driverText(); },
                   [&](const Result<std::string>& text) { found = *text; });
        worker.resume();
        ASSERT_TRUE(comesToRest(worker));
        rests.get_future().wait();
    }
    EXPECT_NE(found, "");
    EXPECT_EQ(atRest, found);
}

TEST_F(WorkerTest, ThreadThatRested_IsThereAgainForTheNextRequest) {
    std::atomic<int> rests = 0;
    Worker worker{{.atRest = [&] { ++rests; }}};
    for (int i = 1; i <= 3; ++i) {
        worker.ask(workFor(i), taken());
        ASSERT_TRUE(QTest::qWaitFor([&] { return rests == i; }, waitMs));
    }
    ASSERT_TRUE(comesToRest(worker));
    EXPECT_EQ(results(), (std::vector{1, 2, 3}));
}

TEST_F(WorkerTest, Patience_KeepsTheThreadAwake) {
    std::atomic<int> rests = 0;
    {
        Worker worker{{.patience = std::chrono::hours(1), .atRest = [&] { ++rests; }}};
        worker.ask(workFor(1), taken());
        ASSERT_TRUE(comesToRest(worker));
        QTest::qWait(shortMs);
        EXPECT_EQ(rests, 0);
    }
    EXPECT_EQ(rests, 1);
}

} // namespace
} // namespace patina::tests::worker_test
