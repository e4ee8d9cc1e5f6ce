// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/steps.h"

#include <memory>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace patina::tests::steps_test {
namespace {

Steps counted(std::vector<int>& log, int from, int to) {
    for (int i = from; i < to; ++i) {
        log.push_back(i);
        co_yield Steps::Pause();
    }
}

Steps joined(std::vector<int>& log) {
    co_await counted(log, 0, 2);
    log.push_back(10);
    co_await counted(log, 20, 20); // nothing to do
    log.push_back(30);
    co_yield Steps::Pause();
    log.push_back(40);
}

int stepsOf(Steps& steps) {
    int count = 0;
    for (; !steps.isDone(); ++count) {
        steps.step();
    }
    return count;
}

TEST(Steps, Step_EndsAtTheNextPause) {
    std::vector<int> log;
    Steps steps = counted(log, 0, 3);
    EXPECT_TRUE(log.empty());
    steps.step();
    EXPECT_EQ(log, (std::vector<int>{0}));
    steps.step();
    EXPECT_EQ(log, (std::vector<int>{0, 1}));
    EXPECT_FALSE(steps.isDone());
}

TEST(Steps, PartsOfThem_AreStepsOfTheWhole) {
    std::vector<int> log;
    Steps steps = joined(log);
    EXPECT_EQ(stepsOf(steps), 4); // two of the first part, one to the pause behind it, the end
    EXPECT_EQ(log, (std::vector<int>{0, 1, 10, 30, 40}));
}

TEST(Steps, WithoutWork_AreDone) {
    Steps steps;
    EXPECT_TRUE(steps.isDone());
    steps.step();
    EXPECT_TRUE(steps.isDone());
}

Steps keeping(std::shared_ptr<int> kept) {
    co_yield Steps::Pause();
    *kept = 1;
}

Steps keepingInAPart(std::shared_ptr<int> kept) {
    co_await keeping(std::move(kept));
}

TEST(Steps, DestroyedAtAPause_DestroyTheirVariables) {
    const auto kept = std::make_shared<int>(0);
    {
        Steps steps = keepingInAPart(kept);
        steps.step();
        EXPECT_GT(kept.use_count(), 1);
    }
    EXPECT_EQ(kept.use_count(), 1);
    EXPECT_EQ(*kept, 0);
}

Steps throwing() {
    co_yield Steps::Pause();
    throw std::runtime_error("broken");
}

Steps throwingInAPart() {
    co_await throwing();
}

TEST(Steps, WhatTheWorkThrows_ComesOutAndEndsThem) {
    Steps steps = throwingInAPart();
    steps.step();
    EXPECT_THROW(steps.step(), std::runtime_error);
    EXPECT_TRUE(steps.isDone());
}

Steps assigned(int& count) {
    ++count;
    co_yield Steps::Pause();
}

TEST(Steps, AnotherWorkAssigned_TakesItsPlace) {
    int first = 0;
    int second = 0;
    Steps steps = assigned(first);
    steps.step();
    steps = assigned(second);
    steps.step();
    EXPECT_EQ(first, 1);
    EXPECT_EQ(second, 1);
}

} // namespace
} // namespace patina::tests::steps_test
