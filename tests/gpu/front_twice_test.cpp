// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a front is the same when it is measured again, by times with the noise of a busy machine.
// What real frames give, `packaging/benchmark front-twice` tells.
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "support/front_share.h"

namespace patina::front_twice_test {
namespace {

/// Milliseconds of frames on a machine that others use, too: it gets slower and faster for all,
/// every frame differs a little, and now and then one is held up.
class BusyMachine {
  public:
    explicit BusyMachine(unsigned seed) : random_(seed) {}

    void drift() { pace_ *= std::exp(0.05 * normal_(random_)); }

    double timeOf(double milliseconds) {
        const double held = share_(random_) < 0.05 ? 1.0 + share_(random_) : 1.0;
        return pace_ * held * milliseconds * std::exp(0.03 * normal_(random_));
    }

  private:
    std::mt19937 random_;
    std::normal_distribution<double> normal_;
    std::uniform_real_distribution<double> share_;
    double pace_ = 1.0;
};

struct KnownSetting {
    ChosenLevels levels;
    double ratio = 1.0;
    double error = 0.0;
};

/// The exact way and a dozen others, most of them faster.
std::vector<KnownSetting> someWays(std::mt19937& random) {
    std::uniform_real_distribution<double> share;
    std::vector<KnownSetting> ways(1);
    for (int i = 0; i < 12; ++i) {
        ways.push_back({{{"a", std::to_string(i)}},
                        0.3 + 0.8 * share(random),
                        std::pow(10.0, -6.0 * share(random))});
    }
    return ways;
}

CostChart measured(const std::vector<KnownSetting>& ways, BusyMachine& machine) {
    constexpr MedianInterval empty{1.0, 0.98, 1.02};
    constexpr double exactMilliseconds = 9.0;
    CostChart chart;
    for (const KnownSetting& way : ways) {
        CostPairs pairs({}, empty);
        while (!pairs.finished()) {
            machine.drift();
            const double exact = machine.timeOf(exactMilliseconds);
            pairs.add(empty.median + exact,
                      empty.median + machine.timeOf(way.ratio * exactMilliseconds));
        }
        CostPoint point;
        point.levels = way.levels;
        point.error.p99 = way.error;
        if (!point.isExact()) {
            point.cost = pairs.cost();
        }
        chart.points.push_back(point);
    }
    return chart;
}

TEST(FrontTwice, BusyMachine_HasNineteenOfTwentyPointsAgain) {
    constexpr int charts = 100;
    constexpr double minShare = 0.95;
    std::mt19937 random(11);
    BusyMachine machine(12);
    tests::FrontShare whole;
    for (int i = 0; i < charts; ++i) {
        const std::vector<KnownSetting> ways = someWays(random);
        const CostChart first = measured(ways, machine);
        const CostChart second = measured(ways, machine);
        whole += tests::frontShare(first, second);
    }
    EXPECT_GT(whole.points, std::size_t(3 * charts));
    EXPECT_GE(whole.share(), minShare);
}

} // namespace
} // namespace patina::front_twice_test
