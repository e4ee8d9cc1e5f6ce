// SPDX-License-Identifier: GPL-3.0-or-later
// What accuracy costs, from the command line.
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/patina_program.h"

namespace patina::tests {
namespace {

/// Small and short: what is tested is not the time.
Outcome cost(const std::vector<std::string>& more) {
    std::vector<std::string> command{"cost", "--model", "phong", "--size", "32x32",
                                     "--seconds", "3", "--singles"};
    command.insert(command.end(), more.begin(), more.end());
    return patina(command);
}

TEST(Cost, Table_NamesEveryLevel) {
    const Outcome outcome = cost({});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    for (const char* word : {"exact", "power=rational", "double precision", "glFinish"}) {
        EXPECT_NE(outcome.out.find(word), std::string::npos) << word << '\n' << outcome.out;
    }
}

TEST(Cost, Json_HasErrorsTimesAndInstructions) {
    const Outcome outcome = cost({"--json"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const auto json = nlohmann::json::parse(outcome.out);
    const auto& points = json.at(0).at("points");
    EXPECT_TRUE(points.at(0).at("levels").empty());
    EXPECT_LE(points.at(0).at("error").at("p99").get<double>(), 1e-4);
    for (const auto& point : points) {
        EXPECT_GT(point.at("nanosecondsPerPixel").get<double>(), 0.0);
        EXPECT_GT(point.at("instructions").at("total").get<int>(), 0);
    }
}

TEST(Cost, Csv_HasALineForEachPoint) {
    const Outcome outcome = cost({"--csv"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_TRUE(outcome.out.starts_with("preset,levels,ratio"));
    EXPECT_NE(outcome.out.find("\"phong\",\"power=rational\","), std::string::npos);
}

TEST(Cost, BudgetOfError_BuysAPoint) {
    const Outcome outcome = cost({"--budget-error", "10"});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("the budget buys"), std::string::npos) << outcome.out;
}

TEST(Cost, BudgetThatCannotBeMet_FailsAndNamesTheNearest) {
    const Outcome outcome = cost({"--budget-ms", "0.000001"});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_NE(outcome.err.find("the nearest is"), std::string::npos) << outcome.err;
}

TEST(Cost, Plot_IsDrawn) {
    const TemporaryFolder folder;
    const auto file = folder / "chart.svg";
    const Outcome outcome = cost({"--plot", file.string()});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    std::stringstream text;
    text << std::ifstream(file).rdbuf();
    EXPECT_TRUE(text.str().starts_with("<svg"));
    EXPECT_NE(text.str().find("exact"), std::string::npos);
}

TEST(Cost, ErrorMap_IsAPicture) {
    const TemporaryFolder folder;
    const auto file = folder / "errors.png";
    const Outcome outcome = cost({"--error-map", file.string()});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    std::stringstream bytes;
    bytes << std::ifstream(file, std::ios::binary).rdbuf();
    EXPECT_TRUE(bytes.str().starts_with("\x89PNG"));
    EXPECT_NE(outcome.err.find("shows where"), std::string::npos) << outcome.err;
}

TEST(Cost, Scaling_HasALawForEachAxis) {
    const Outcome outcome = patina({"cost", "--model", "lambert", "--size", "32x32", "--scaling",
                                    "--json"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const auto json = nlohmann::json::parse(outcome.out);
    ASSERT_EQ(json.size(), 3u);
    for (const auto& curve : json) {
        EXPECT_FALSE(curve.at("law").is_null()) << curve.dump();
    }
}

TEST(Cost, NothingToMeasure_IsAMistake) {
    EXPECT_EQ(patina({"cost"}).exitCode, 1);
}

} // namespace
} // namespace patina::tests
