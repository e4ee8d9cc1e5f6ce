// SPDX-License-Identifier: GPL-3.0-or-later
// What tables, CSV and JSON say of measurements, from made-up ones.
#include "measure/cost/cost_table.h"

#include <gtest/gtest.h>

namespace patina::cost_table_test {
namespace {

/// An exact point, and another with these levels.
CostChart chartWith(const ChosenLevels& levels, double ratio, double error) {
    CostChart chart;
    chart.points.resize(2);
    chart.points[1].levels = levels;
    chart.points[1].error.p99 = error;
    const auto time = [](CostPoint& point, double times) {
        point.cost.ratio = {times, 0.99 * times, 1.01 * times};
        point.cost.milliseconds = {10.0 * times, 9.9 * times, 10.1 * times};
        point.cost.runs = 20;
    };
    time(chart.points[0], 1.0);
    time(chart.points[1], ratio);
    return chart;
}

TEST(CostTable, TiesAndTimesBelowTheNoise_AreNamed) {
    CostChart chart = chartWith({{"a", "same"}}, 1.01, 0.0);
    EXPECT_NE(costText(chart).find("exact cannot be told from a=same"), std::string::npos);
    EXPECT_EQ(costJson(chart)["points"][0]["ties"], nlohmann::json({1}));
    chart = chartWith({{"a", "none"}}, 0.02, 0.1);
    EXPECT_EQ(costText(chart).find("cannot be told from a"), std::string::npos);
    chart.points[1].cost.belowNoise = true;
    EXPECT_NE(costText(chart).find("<0.020"), std::string::npos);
}

TEST(CostTable, PointsThatTieWithTheFront_AreMarked) {
    const CostChart chart = chartWith({{"a", "same"}}, 1.01, 0.0);
    EXPECT_NE(costText(chart).find("\n* exact"), std::string::npos) << costText(chart);
    EXPECT_NE(costText(chart).find("\n= a=same"), std::string::npos) << costText(chart);
    const std::string csv = costCsv(chart, "ball", true);
    EXPECT_NE(csv.find("below_noise,tie,predicted_for\n"), std::string::npos) << csv;
    EXPECT_NE(csv.find(",0,0,\"\"\n"), std::string::npos) << csv;
    EXPECT_TRUE(csv.ends_with(",0,1,\"\"\n")) << csv;
}

TEST(CostTable, PredictedTimes_AreCalledSo) {
    CostChart chart = chartWith({{"a", "fast"}}, 0.5, 0.1);
    EXPECT_EQ(costText(chart).find("predicted"), std::string::npos);
    chart.predictedFor = "Steam Deck (RDNA 2)";
    EXPECT_NE(costText(chart).find("predicted time"), std::string::npos);
    EXPECT_EQ(costText(chart).find("of 95 % of runs"), std::string::npos);
    EXPECT_TRUE(costCsv(chart, "ball", true).ends_with(",\"Steam Deck (RDNA 2)\"\n"));
}

TEST(CostTable, LeftOutCombinations_AreTold) {
    CostChart chart = chartWith({{"a", "fast"}}, 0.5, 0.1);
    EXPECT_EQ(costText(chart).find("left out"), std::string::npos);
    chart.leftOut = 27;
    EXPECT_NE(costText(chart).find("27 combinations of choices were left out for want of time\n"),
              std::string::npos);
    EXPECT_EQ(costJson(chart)["leftOut"], 27);
}

/// Two levels of samples that are drawn alike, with so many; 0: another choice.
std::string sameTextOf(int samples) {
    CostChart chart;
    Choice choice;
    choice.id = "samples";
    choice.label = "Samples";
    choice.levels = {{"8", "8 samples", ""}, {"4", "4 samples", ""}, {"1", "1 sample", ""}};
    chart.choices = {choice};
    chart.same = {{"samples", "4", "8", samples}};
    return sameText(chart);
}

TEST(SameText, LevelsOfSamples_AreDrawnAsTheDeviceDrawsThem) {
    EXPECT_EQ(sameTextOf(4), "Samples: 8 samples, 4 samples are both drawn with 4 here");
    EXPECT_EQ(sameTextOf(0), "Samples: 4 samples is drawn as 8 samples");
}

TEST(CostFromJson, WrittenChart_IsReadAgain) {
    CostChart chart = chartWith({{"a", "fast"}}, 0.5, 0.25);
    Choice choice{Choice::Scope::Picture, "a", "b", "A", "What.", "Block", {}};
    choice.levels = {{"best", "Best", "Right."}, {"fast", "Fast", "Wrong."}};
    chart.choices = {choice};
    chart.points[0].instructions = InstructionCount{1, 2, 3, 4, 5};
    for (CostPoint& point : chart.points) {
        point.cost.runs = 9;
        point.error.pixels = 77;
    }
    chart.size = {64, 32};
    chart.pixels = 77;
    chart.exactMilliseconds = 1.5;
    chart.timer = "a clock";
    chart.groundTruth = "the truth";
    chart.same = {{"a", "worst", "fast", 4}};
    chart.converged = ConvergedRender{"a", 4096, {}, {}};
    chart.leftOut = 3;
    const auto read = costFromJson(costJson(chart));
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(*read, chart);
}

TEST(CostFromJson, DamagedChart_IsAnError) {
    const nlohmann::json whole = costJson(chartWith({{"a", "fast"}}, 0.5, 0.25));
    ASSERT_TRUE(costFromJson(whole));
    for (const auto& [name, value] : whole.items()) {
        nlohmann::json without = whole;
        without.erase(name);
        EXPECT_FALSE(costFromJson(without)) << name;
    }
    nlohmann::json wrong = whole;
    wrong["points"][0]["ratio"] = "fast";
    EXPECT_FALSE(costFromJson(wrong));
    wrong = whole;
    wrong["points"].erase(0);
    EXPECT_FALSE(costFromJson(wrong));
    EXPECT_FALSE(costFromJson(nlohmann::json::array()));
}

TEST(CostTable, PointsAgainstAConvergedRender_SaySo) {
    CostChart chart = chartWith({{"picture.environment", "16"}}, 0.1, 0.3);
    EXPECT_EQ(costText(chart).find('~'), std::string::npos);
    EXPECT_TRUE(costJson(chart)["converged"].is_null());
    chart.converged = ConvergedRender{"picture.environment", 4096, {}, {}};
    chart.converged->noise.p99 = 0.002;
    EXPECT_NE(costText(chart).find("~ 3.0e-01"), std::string::npos) << costText(chart);
    EXPECT_NE(costText(chart).find("4096 other directions"), std::string::npos);
    const nlohmann::json json = costJson(chart);
    EXPECT_EQ(json["converged"]["noise"]["p99"], 0.002);
    EXPECT_EQ(json["points"][0]["againstConverged"], false);
    EXPECT_EQ(json["points"][1]["againstConverged"], true);
}

TEST(CostTable, PointOfTooFewRuns_HasNoBounds) {
    CostChart chart = chartWith({{"a", "fast"}}, 0.5, 0.1);
    chart.points[1].cost.runs = 1;
    const std::string csv = costCsv(chart, "ball", false);
    EXPECT_NE(csv.find("\"ball\",\"a=fast\",0.5,,,"), std::string::npos) << csv;
    const nlohmann::json json = costJson(chart);
    EXPECT_TRUE(json["points"][0]["ratio"]["lower"].is_number());
    EXPECT_TRUE(json["points"][1]["ratio"]["lower"].is_null());
    EXPECT_TRUE(json["points"][1]["ratio"]["upper"].is_null());
    EXPECT_EQ(json["points"][1]["ratio"]["median"], 0.5);
}

TEST(CostCsv, QuotationMarksInAName_AreDoubled) {
    const std::string csv = costCsv(chartWith({}, 1.0, 0.0), "5\" ball", false);
    EXPECT_TRUE(csv.starts_with("\"5\"\" ball\",\"exact\",")) << csv;
}

} // namespace
} // namespace patina::cost_table_test
