// SPDX-License-Identifier: GPL-3.0-or-later
// What pairs of times say of a ratio, from made-up times.
#include "measure/time/choice_cost.h"

#include <vector>

#include <gtest/gtest.h>

namespace patina::cost_pairs_test {
namespace {

TEST(CostPairs, EqualTimes_SettleAtOnce) {
    CostPairs pairs({}, {});
    for (int i = 0; i < 7; ++i) {
        EXPECT_FALSE(pairs.finished());
        pairs.add(2.0, 1.0);
    }
    EXPECT_TRUE(pairs.finished());
    EXPECT_TRUE(pairs.cost().settled);
    EXPECT_DOUBLE_EQ(pairs.cost().ratio.median, 0.5);
}

TEST(CostPairs, EmptyFrame_CountsForNothing) {
    CostPairs pairs({}, {1.0, 1.0, 1.0});
    pairs.add(3.0, 2.0);
    EXPECT_DOUBLE_EQ(pairs.cost().ratio.median, 0.5);
}

TEST(CostPairs, TimesThatAreNoLongerThanAnEmptyFrames_AreBoundsAndSayIt) {
    CostPairs pairs({}, {1.0, 0.99, 1.03});
    for (int i = 0; i < 7; ++i) {
        pairs.add(5.0, i % 2 == 0 ? 0.98 : 1.01);
    }
    EXPECT_TRUE(pairs.cost().belowNoise);
    EXPECT_DOUBLE_EQ(pairs.cost().ratio.median, (1.03 - 0.99) / 4.0);
    CostPairs others({}, {1.0, 0.99, 1.03});
    others.add(5.0, 1.2);
    EXPECT_FALSE(others.cost().belowNoise);
}

TEST(CostPairs, ExactTimesBelowTheNoise_AreNeverSettled) {
    CostPairs pairs({}, {1.0, 0.99, 1.03});
    for (int i = 0; i < 7; ++i) {
        pairs.add(1.01, 1.01);
    }
    EXPECT_DOUBLE_EQ(pairs.cost().ratio.upper - pairs.cost().ratio.lower, 0.0);
    EXPECT_FALSE(pairs.cost().settled);
}

TEST(EmptyFrames, OneThatTookLong_IsNoNoise) {
    std::vector<double> times(emptyFrames, 1.0);
    times.front() = 100.0;
    EXPECT_DOUBLE_EQ(medianInterval(times).upper, 1.0);
}

TEST(CostPairs, Times_FollowFromTheRatio) {
    ChoiceCost cost;
    cost.ratio = {0.5, 0.25, 1.0};
    const ChoiceCost timed = withTimes(cost, {3.0, {1.0, 1.0, 1.0}, 1000});
    EXPECT_EQ(timed.milliseconds, (MedianInterval{2.0, 1.5, 3.0}));
    EXPECT_DOUBLE_EQ(timed.nanosecondsPerPixel, 1000.0);
}

TEST(CostPairs, RestlessTimes_EndUnsettled) {
    CostPairs pairs({0.03, 7, 20}, {});
    for (int i = 0; i < 20; ++i) {
        pairs.add(1.0, i % 2 == 0 ? 0.5 : 2.0);
    }
    EXPECT_TRUE(pairs.finished());
    EXPECT_FALSE(pairs.cost().settled);
}

} // namespace
} // namespace patina::cost_pairs_test
