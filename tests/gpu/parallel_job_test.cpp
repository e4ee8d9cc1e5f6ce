// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/error/parallel_job.h"

#include <vector>

#include <gtest/gtest.h>

namespace patina::parallel_job_test {
namespace {

constexpr std::size_t places = 100'000; ///< several pieces

TEST(ParallelJob, Finished_HasDoneEveryPlaceOnce) {
    std::vector<int> times(places);
    ParallelJob work;
    work.add(places, [&times](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            ++times[i];
        }
    });
    work.finish();
    EXPECT_EQ(times, std::vector<int>(places, 1));
}

TEST(ParallelJob, LaterStage_SeesAllOfTheOneBefore) {
    std::vector<int> first(places);
    std::vector<int> mirrored(places);
    ParallelJob work;
    work.add(places, [&first](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            first[i] = static_cast<int>(i) + 1;
        }
    });
    work.add(places, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            mirrored[i] = first[places - 1 - i];
        }
    });
    work.finish();
    EXPECT_EQ(mirrored.front(), static_cast<int>(places));
    EXPECT_EQ(mirrored.back(), 1);
}

TEST(ParallelJob, WithoutPatience_DoesOnePieceAStep) {
    std::vector<int> done(places);
    int asked = 0;
    ParallelJob work;
    work.add(places, [&done](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            done[i] = 1;
        }
    });
    work.addOnce([&asked] { ++asked; });
    int steps = 1;
    while (!work.step(std::chrono::milliseconds(0))) {
        ++steps;
    }
    EXPECT_GT(steps, 3);
    EXPECT_EQ(asked, 1);
    EXPECT_TRUE(work.isDone());
}

TEST(ParallelJob, WithoutPlaces_IsDone) {
    ParallelJob work;
    work.add(0, [](std::size_t, std::size_t) { FAIL(); });
    EXPECT_TRUE(work.isDone());
    EXPECT_TRUE(work.step(std::chrono::milliseconds(0)));
}

} // namespace
} // namespace patina::parallel_job_test
