// SPDX-License-Identifier: GPL-3.0-or-later
// Fronts, budgets and the order of measuring, from made-up measurements.
#include "measure/cost/cost_chart.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "measure/cost/cost_table.h"
#include "measure/cost/ranking_table.h"
#include "measure/cost/sweep_plan.h"

namespace patina::cost_chart_test {
namespace {

CostPoint point(const ChosenLevels& levels, double ratio, double error) {
    CostPoint made;
    made.levels = levels;
    made.cost.ratio = {ratio, 0.99 * ratio, 1.01 * ratio};
    made.cost.milliseconds = {10.0 * ratio, 9.9 * ratio, 10.1 * ratio};
    made.cost.runs = 20;
    made.error.p99 = error;
    return made;
}

const std::vector<CostPoint>& someFront() {
    static const std::vector<CostPoint> points{
        point({}, 1.0, 1e-7), point({{"a", "fast"}}, 0.5, 0.01), point({{"a", "slow"}}, 0.9, 0.02),
        point({{"a", "fastest"}}, 0.25, 0.1)};
    return points;
}

TEST(CostFront, Beaten_AreLeftOut) {
    EXPECT_EQ(costFront(someFront()), (std::vector<std::size_t>{3, 1, 0}));
}

TEST(CostFront, PointsThatTieWithOneOfIt_AreTold) {
    const std::vector<CostPoint> points{point({}, 1.0, 0.0), point({{"a", "same"}}, 0.99, 0.0),
                                        point({{"a", "worse"}}, 1.01, 0.5)};
    EXPECT_EQ(standings(points),
              (std::vector<Standing>{Standing::OnFront, Standing::Tie, Standing::Beaten}));
}

TEST(CostFront, FasterByNoMoreThanTheNoise_IsATie) {
    const std::vector<CostPoint> points{point({}, 1.0, 0.0), point({{"a", "fast"}}, 0.5, 0.01),
                                        point({{"a", "faster"}}, 0.495, 0.1),
                                        point({{"a", "slower"}}, 0.505, 0.1),
                                        point({{"a", "between"}}, 0.9, 0.1)};
    EXPECT_EQ(standings(points),
              (std::vector<Standing>{Standing::OnFront, Standing::OnFront, Standing::Tie,
                                     Standing::Beaten, Standing::Beaten}));
}

// Compilers count the same cycles each time.
TEST(CostFront, PredictedTimes_HaveNoNoise) {
    std::vector<CostPoint> points{point({}, 1.0, 0.0), point({{"a", "little"}}, 0.994, 0.01),
                                  point({{"a", "alike"}}, 0.994, 0.01),
                                  point({{"a", "slower"}}, 0.9941, 0.02)};
    EXPECT_EQ(costFront(points), std::vector<std::size_t>{0}) << "measured";
    for (CostPoint& each : points) {
        const double ratio = each.cost.ratio.median;
        each.cost = {};
        each.cost.ratio = {ratio, ratio, ratio};
    }
    EXPECT_EQ(standings(points), (std::vector<Standing>{Standing::OnFront, Standing::OnFront,
                                                        Standing::Tie, Standing::Beaten}));
}

/// Pairs of the exact frame and itself have their noise, too, but no other point's ratio has it.
TEST(CostFront, NoiseOfTheExactFrame_CountsOnce) {
    std::vector<CostPoint> points{point({}, 1.0, 0.0), point({{"a", "fast"}}, 0.95, 0.1)};
    points[0].cost.ratio = {1.0, 0.95, 1.05};
    EXPECT_EQ(costFront(points), (std::vector<std::size_t>{1, 0}));
}

TEST(CostFront, OfTiesInBoth_TheExactOneIsOnIt) {
    EXPECT_EQ(costFront({point({{"a", "same"}}, 0.99, 0.0), point({}, 1.0, 0.0)}),
              std::vector<std::size_t>{1});
}

TEST(CostFront, ExactOneThatIsSlower_IsLeftOut) {
    EXPECT_EQ(costFront({point({}, 1.0, 1e-8), point({{"a", "half"}}, 0.5, 1e-7)}),
              std::vector<std::size_t>{1});
}

/// Each ties with the next one in time, the first and the last do not.
TEST(CostFront, ChainOfTies_IsCutWhereItIsFasterByMoreThanNoise) {
    EXPECT_EQ(costFront({point({}, 1.0, 0.0), point({{"a", "1"}}, 0.985, 0.01),
                         point({{"a", "2"}}, 0.96, 0.02), point({{"a", "3"}}, 0.945, 0.03)}),
              (std::vector<std::size_t>{2, 0}));
}

/// Crowded, so that most points tie with some others, and many are equally accurate.
std::vector<CostPoint> randomPoints(std::mt19937& random) {
    std::uniform_real_distribution<double> share(0.0, 1.0);
    std::vector<CostPoint> points{point({}, 1.0, 1e-8)};
    for (int i = 0; i < 24; ++i) {
        const double error = std::pow(10.0, -8.0 * share(random));
        points.push_back(point({{"a", std::to_string(i)}}, 0.8 + 0.3 * share(random),
                               i % 3 == 0 ? 1e-7 * share(random) : error));
    }
    return points;
}

std::set<ChosenLevels> frontLevels(const std::vector<CostPoint>& points) {
    std::set<ChosenLevels> levels;
    for (const std::size_t i : costFront(points)) {
        levels.insert(points[i].levels);
    }
    return levels;
}

bool isAsGood(const CostPoint& a, const CostPoint& b) {
    return std::max(errorOf(a), 1e-6) <= std::max(errorOf(b), 1e-6) &&
           (a.cost.ratio.median <= b.cost.ratio.median || tiesInTime(a, b));
}

TEST(CostFront, RandomPoints_AreOnItOrHaveOneThatIsAsGood) {
    std::mt19937 random(7);
    for (int round = 0; round < 200; ++round) {
        const std::vector<CostPoint> points = randomPoints(random);
        const std::vector<std::size_t> front = costFront(points);
        for (std::size_t i = 0; i < points.size(); ++i) {
            const auto others = std::ranges::count_if(front, [&](std::size_t other) {
                return other != i && isAsGood(points[other], points[i]);
            });
            EXPECT_EQ(others > 0, std::ranges::find(front, i) == front.end()) << round << ' ' << i;
        }
    }
}

TEST(CostFront, RandomPoints_CountInAnyOrder) {
    std::mt19937 random(8);
    for (int round = 0; round < 200; ++round) {
        std::vector<CostPoint> points = randomPoints(random);
        const std::set<ChosenLevels> front = frontLevels(points);
        std::ranges::shuffle(points, random);
        EXPECT_EQ(frontLevels(points), front) << round;
    }
}

TEST(CostFront, PointsThatAreNotOnIt_MakeNoDifference) {
    std::mt19937 random(9);
    for (int round = 0; round < 200; ++round) {
        std::vector<CostPoint> points = randomPoints(random);
        const std::set<ChosenLevels> front = frontLevels(points);
        int kept = 0;
        std::erase_if(points, [&](const CostPoint& each) {
            return !front.contains(each.levels) && ++kept % 2 == 0;
        });
        EXPECT_EQ(frontLevels(points), front) << round;
    }
}

TEST(BestFor, RandomPoints_CountInAnyOrder) {
    std::mt19937 random(10);
    for (int round = 0; round < 200; ++round) {
        std::vector<CostPoint> points = randomPoints(random);
        for (const CostBudget& budget : {CostBudget{9.5, {}}, CostBudget{{}, 1e-3}}) {
            const CostPoint first = points[bestFor(budget, points)->point];
            std::ranges::shuffle(points, random);
            EXPECT_EQ(points[bestFor(budget, points)->point].levels, first.levels) << round;
        }
    }
}

TEST(CostFront, SameTimeAndWorse_IsLeftOut) {
    EXPECT_EQ(costFront({point({}, 1.0, 0.0), point({{"a", "worse"}}, 0.99, 0.1)}),
              std::vector<std::size_t>{0});
}

TEST(CostFront, ErrorsOfRounding_AreTheSame) {
    EXPECT_TRUE(tiesInError(point({}, 1.0, 1e-9), point({}, 1.0, 9e-7)));
}

TEST(BestFor, Time_BuysTheLeastError) {
    const auto answer = bestFor({6.0, {}}, someFront());
    ASSERT_TRUE(answer);
    EXPECT_TRUE(answer->fits);
    EXPECT_EQ(answer->point, 1u);
}

TEST(BestFor, Error_BuysTheLeastTime) {
    const auto answer = bestFor({{}, 0.05}, someFront());
    ASSERT_TRUE(answer);
    EXPECT_EQ(answer->point, 1u);
}

TEST(BestFor, TooLittleTime_NamesTheNearest) {
    const auto answer = bestFor({1.0, {}}, someFront());
    ASSERT_TRUE(answer);
    EXPECT_FALSE(answer->fits);
    EXPECT_EQ(answer->point, 3u);
}

TEST(BestFor, NoPoints_HaveNoAnswer) {
    EXPECT_FALSE(bestFor({1.0, {}}, {}));
}

TEST(CostChart, TooFewPairs_TieWithEverything) {
    CostPoint fast = point({{"a", "fast"}}, 0.5, 0.1);
    EXPECT_FALSE(tiesInTime(fast, point({}, 1.0, 0.0)));
    fast.cost.runs = 1;
    EXPECT_TRUE(tiesInTime(fast, point({}, 1.0, 0.0)));
    CostChart chart;
    chart.points = {fast};
    EXPECT_NE(costText(chart).find("!  "), std::string::npos);
}

TEST(BestFor, NearestOfThoseThatTakeAsLong_IsTheMostAccurate) {
    const std::vector<CostPoint> points{point({}, 1.0, 0.0), point({{"a", "good"}}, 0.905, 0.001),
                                        point({{"a", "poor"}}, 0.9, 0.2)};
    CostBudget budget;
    budget.milliseconds = 1e-9;
    const auto answer = bestFor(budget, points);
    ASSERT_TRUE(answer);
    EXPECT_FALSE(answer->fits);
    EXPECT_EQ(answer->point, 1u);
}

TEST(LevelsText, IsReadAgain) {
    const ChosenLevels levels{{"a", "fast"}, {"fresnel.b", "table"}};
    EXPECT_EQ(levelsFromText(levelsText(levels)), levels);
    EXPECT_EQ(levelsFromText("exact"), ChosenLevels());
    EXPECT_FALSE(levelsFromText("fast"));
    EXPECT_FALSE(levelsFromText("a="));
}

/// An exact time that is nothing, as far as can be told, is no measure for others.
TEST(CostTable, TimesBesideABound_AreAtLeastThat) {
    CostChart chart;
    chart.points = {point({}, 1.0, 0.0), point({{"a", "slow"}}, 4.0, 0.1),
                    point({{"a", "none"}}, 1.0, 0.2)};
    chart.points[0].cost.belowNoise = true;
    chart.points[2].cost.belowNoise = true;
    chart.points[0].cost.nanosecondsPerPixel = 2.5;
    chart.points[1].cost.nanosecondsPerPixel = 10.0;
    const std::string text = costText(chart);
    EXPECT_NE(text.find(">4.000 ("), std::string::npos) << text;
    EXPECT_NE(text.find(" <2.50 "), std::string::npos) << text;
    EXPECT_NE(text.find(" 10.00 "), std::string::npos) << text;
    EXPECT_EQ(text.find("1.000 ("), std::string::npos) << text;
}

ModelCost modelCost(const char* name, double ratio, bool belowNoise) {
    ModelCost made{name, name, point({}, ratio, 0.0).cost, std::nullopt, std::nullopt};
    made.cost.belowNoise = belowNoise;
    return made;
}

TEST(CountFromQuickest, QuickestThatIsABound_LeavesLeastRatios) {
    std::vector<ModelCost> costs{modelCost("a", 0.5, true), modelCost("b", 0.6, true),
                                 modelCost("c", 2.0, false)};
    countFromQuickest(costs);
    EXPECT_EQ(costs[0].bound, RatioBound::Unknown);
    EXPECT_EQ(costs[1].bound, RatioBound::Unknown);
    EXPECT_EQ(costs[2].bound, RatioBound::AtLeast);
    EXPECT_DOUBLE_EQ(costs[2].cost.ratio.median, 4.0);
    EXPECT_NE(rankingText(costs).find(">4.00 ("), std::string::npos) << rankingText(costs);
    EXPECT_EQ(rankingJson(costs)[1]["belowNoise"], true);
}

TEST(CountFromQuickest, Intervals_HoldWhatIsNotKnownOfTheQuickestEither) {
    std::vector<ModelCost> costs{modelCost("a", 0.5, false), modelCost("b", 1.0, false)};
    costs[0].cost.ratio = {0.5, 0.4, 0.8};
    costs[1].cost.ratio = {1.0, 0.9, 1.2};
    countFromQuickest(costs);
    EXPECT_EQ(costs[0].cost.ratio, (MedianInterval{1.0, 1.0, 1.0}));
    EXPECT_EQ(costs[1].cost.ratio, (MedianInterval{2.0, 0.9 / 0.8, 1.2 / 0.4}));
}

TEST(CountFromQuickest, BoundBesideAQuickerModel_IsTheMostThatItTakes) {
    std::vector<ModelCost> costs{modelCost("a", 0.5, false), modelCost("b", 0.6, true)};
    countFromQuickest(costs);
    EXPECT_EQ(costs[0].bound, RatioBound::None);
    EXPECT_EQ(costs[1].bound, RatioBound::AtMost);
}

TEST(RankingText, TooFewPairs_AreMarked) {
    std::vector<ModelCost> costs{modelCost("a", 1.0, false)};
    costs[0].cost.runs = 2;
    EXPECT_NE(rankingText(costs).find(")! "), std::string::npos) << rankingText(costs);
}

TEST(RankingText, LossThatRoundsToNothing_HasNoSign) {
    std::vector<ModelCost> costs{modelCost("a", 1.0, false)};
    costs[0].albedoLoss = -1e-7;
    EXPECT_EQ(rankingText(costs).find("-0.0 %"), std::string::npos) << rankingText(costs);
    EXPECT_NE(rankingText(costs).find(" 0.0 %"), std::string::npos) << rankingText(costs);
}

Choice choiceOf(const std::string& id, int levels) {
    Choice choice;
    choice.id = id;
    for (int i = 0; i < levels; ++i) {
        choice.levels.push_back({std::to_string(i), "", ""});
    }
    return choice;
}

/// Measures what a plan asks for, each level as fast and as wrong as its number says.
CostChart followed(SweepPlan& plan) {
    CostChart chart;
    while (const auto levels = plan.next(chart)) {
        double ratio = 1.0;
        double error = 0.0;
        for (const auto& [choice, level] : *levels) {
            ratio *= 1.0 / (1.0 + std::stoi(level));
            error += 0.01 * std::stoi(level);
        }
        chart.points.push_back(point(*levels, ratio, error));
    }
    return chart;
}

TEST(SweepPlan, Exact_ComesFirst) {
    SweepPlan plan({choiceOf("a", 3)}, true);
    EXPECT_TRUE(plan.next({})->empty());
}

TEST(SweepPlan, FewCombinations_AreAllMeasuredOnce) {
    SweepPlan plan({choiceOf("a", 3), choiceOf("b", 3)}, true);
    EXPECT_EQ(followed(plan).points.size(), 9u);
}

TEST(SweepPlan, WithoutCombinations_OnlySinglesAreMeasured) {
    SweepPlan plan({choiceOf("a", 3), choiceOf("b", 3)}, false);
    EXPECT_EQ(followed(plan).points.size(), 5u);
}

TEST(SweepPlan, ManyCombinations_AreGoneThroughGreedily) {
    std::vector<Choice> choices;
    for (int i = 0; i < 12; ++i) {
        choices.push_back(choiceOf("c" + std::to_string(i), 3));
    }
    SweepPlan plan(choices, true);
    const CostChart chart = followed(plan);
    EXPECT_EQ(chart.points.size(), 1u + 24u + 11u);
    EXPECT_EQ(chart.points.back().levels.size(), 12u);
}

TEST(SweepPlan, EndedBeforeCombinations_KnowsHowManyAreLeft) {
    SweepPlan plan({choiceOf("a", 3), choiceOf("b", 3)}, true);
    SweepPlan singles({choiceOf("a", 3), choiceOf("b", 3)}, false);
    CostChart chart = followed(singles);
    for (std::size_t i = 0; i < chart.points.size(); ++i) {
        plan.next(chart);
    }
    EXPECT_EQ(plan.leftOver(chart), 4u);
    CostChart unsure = chart;
    for (CostPoint& each : unsure.points) {
        each.cost.runs = 1; // for want of time
    }
    EXPECT_EQ(plan.leftOver(unsure), 4u);
    chart.points.push_back(point(*plan.next(chart), 0.5, 0.1));
    EXPECT_EQ(plan.leftOver(chart), 3u);
    while (plan.next(chart)) {
    }
    EXPECT_EQ(plan.leftOver(chart), 0u);
    EXPECT_EQ(singles.leftOver(chart), 0u);
}

/// A level that is slower than the exact one is in no combination.
TEST(SweepPlan, WhatGainsNothing_IsNotCombined) {
    SweepPlan plan({choiceOf("a", 2), choiceOf("b", 2)}, true);
    CostChart chart;
    while (const auto levels = plan.next(chart)) {
        chart.points.push_back(point(*levels, levels->contains("b") ? 1.2 : 0.8, 0.1));
    }
    EXPECT_EQ(chart.points.size(), 3u);
}

} // namespace
} // namespace patina::cost_chart_test
