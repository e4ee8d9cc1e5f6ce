// SPDX-License-Identifier: GPL-3.0-or-later
// What accuracy costs, from the command line.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <regex>
#include <sstream>
#include <tuple>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/patina_program.h"

namespace patina::tests::cost_test {
namespace {

const std::string threeLights = shipped("presets/three-lights.patina-scene.json").string();

/// Small, short and without an environment: what is tested is not the time.
Outcome cost(const std::vector<std::string>& more) {
    std::vector<std::string> command{"cost",   "--model", "phong",     "--scene", threeLights,
                                     "--size", "32x32",   "--seconds", "3",       "--singles"};
    command.insert(command.end(), more.begin(), more.end());
    return patina(command);
}

TEST(Cost, SceneWithoutObjects_IsRefused) {
    const TemporaryFolder folder;
    const auto scene = folder / "empty.patina-scene.json";
    writeFile(scene, R"({"format": "patina.scene", "version": 1, "objects": []})");
    const Outcome outcome = patina({"cost", "--scene", scene, "--size", "32x32"});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_NE(outcome.err.find("there is no object to measure"), std::string::npos) << outcome.err;
}

TEST(Cost, Table_NamesEveryLevel) {
    const Outcome outcome = cost({});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    for (const char* word : {"exact", "power=rational", "double precision", "glFinish"}) {
        EXPECT_NE(outcome.out.find(word), std::string::npos) << word << '\n' << outcome.out;
    }
}

TEST(Cost, ChoicesOfAPicturePass_HaveTimesAndErrorsOfTheFinishedPicture) {
    const Outcome outcome = cost({"--picture", "--pass", "kuwahara", "--json"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const auto json = nlohmann::json::parse(outcome.out);
    const auto& points = json.at(0).at("points");
    const auto coarse = std::ranges::find_if(points, [](const nlohmann::json& point) {
        return point.at("levels") == nlohmann::json({{"pass.kuwahara.samples", "coarse"}});
    });
    ASSERT_NE(coarse, points.end()) << outcome.out;
    EXPECT_GT(coarse->at("error").at("mean").get<double>(), 0.0);
    EXPECT_GT(coarse->at("ratio").at("median").get<double>(), 0.0);
    EXPECT_NE(outcome.out.find("ways of picture passes with the finished picture"),
              std::string::npos)
        << outcome.out;
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

TEST(Cost, BudgetsOfTwoPresets_NameThem) {
    const std::string folder = PATINA_SOURCE_DIR "/presets/phong/";
    const Outcome outcome =
        patina({"cost", folder + "billiard-ball.patina.json", folder + "soft-vinyl.patina.json",
                "--size", "16x16", "--seconds", "1", "--singles", "--budget-error", "10"});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    for (const char* name : {"billiard-ball", "soft-vinyl"}) {
        EXPECT_NE(outcome.out.find(name + std::string(".patina.json: the budget buys")),
                  std::string::npos)
            << outcome.out;
    }
}

TEST(Cost, ErrorMapOfAWay_IsThatWays) {
    const TemporaryFolder folder;
    const std::string file = (folder / "errors.png").string();
    const Outcome outcome = cost({"--error-map", file, "--error-map-of", "power=gaussian"});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_NE(outcome.err.find("power=gaussian is wrong"), std::string::npos) << outcome.err;
    const Outcome unknown = cost({"--error-map", file, "--error-map-of", "power=magic"});
    EXPECT_EQ(unknown.exitCode, 1);
    EXPECT_NE(unknown.err.find("there is no power=magic here"), std::string::npos);
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

/// The texts of a chart of many points, with their corners.
std::vector<std::tuple<double, double, std::string>> labelsOfAChart() {
    const TemporaryFolder folder;
    const auto file = folder / "chart.svg";
    const Outcome outcome = patina({"cost", "--model", "cook-torrance", "--fresnel", "dielectric",
                                    "--scene", threeLights, "--size", "32x32", "--seconds", "3",
                                    "--singles", "--plot", file.string()});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    std::stringstream bytes;
    bytes << std::ifstream(file).rdbuf();
    const std::string svg = bytes.str();
    const std::regex form("<text x=\"([0-9.]+)\" y=\"([0-9.]+)\"[^>]*>([^<]*)<");
    std::vector<std::tuple<double, double, std::string>> labels;
    for (std::sregex_iterator i(svg.begin(), svg.end(), form), end; i != end; ++i) {
        labels.emplace_back(std::stod((*i)[1]), std::stod((*i)[2]), (*i)[3]);
    }
    return labels;
}

TEST(Cost, LabelsOfAChart_DoNotMeet) {
    constexpr double lineHeight = 12.0;
    constexpr double letterWidth = 6.0;
    const auto labels = labelsOfAChart();
    EXPECT_FALSE(labels.empty());
    for (std::size_t i = 0; i < labels.size(); ++i) {
        const auto& [x, y, name] = labels[i];
        for (std::size_t k = 0; k < i; ++k) {
            const auto& [otherX, otherY, other] = labels[k];
            const bool meet = std::abs(y - otherY) < lineHeight &&
                              x < otherX + letterWidth * double(other.size()) &&
                              otherX < x + letterWidth * double(name.size());
            EXPECT_FALSE(meet) << name << " over " << other;
        }
    }
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
                                    "--scene", threeLights, "--json"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const auto json = nlohmann::json::parse(outcome.out);
    ASSERT_EQ(json.size(), 3u);
    for (const auto& curve : json) {
        EXPECT_FALSE(curve.at("law").is_null()) << curve.dump();
    }
}

TEST(Cost, Scaling_DrawsPixelsUpToTheSize) {
    const Outcome outcome = patina({"cost", "--model", "lambert", "--size", "48x48", "--scaling",
                                    "--scene", threeLights, "--seconds", "2", "--csv"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("pixels,2304,"), std::string::npos) << outcome.out;
    EXPECT_EQ(outcome.out.find("pixels,4096,"), std::string::npos) << outcome.out;
}

/// Nothing of what is asked for is left out silently.
void expectMistake(const std::vector<std::string>& arguments, const char* words) {
    std::vector<std::string> command{"cost"};
    command.insert(command.end(), arguments.begin(), arguments.end());
    const Outcome outcome = patina(command);
    EXPECT_NE(outcome.exitCode, 0) << words;
    EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.out, "");
}

TEST(Cost, OptionsThatDoNotGoTogether_AreMistakes) {
    expectMistake({"--all-models", "--budget-ms", "2"}, "are of charts of presets");
    expectMistake({"--all-models", "--plot", "a.svg"}, "are of charts of presets");
    expectMistake({"--all-models", "--error-map-of", "power=rational"}, "--error-map-of, ");
    expectMistake({"--all-models", "some.patina.json"}, "ranks models");
    expectMistake({"--model", "phong", "--scaling", "--error-map", "a.png"}, "of charts");
    expectMistake({"--model", "phong", "--scaling", "--size", "64x32"}, "square");
    expectMistake({"--model", "phong", "--samples", "16"}, "--samples");
    expectMistake({"--model", "phong", "--error-map-of", "power=rational"}, "no map to draw");
}

TEST(Cost, PictureThatCannotBeWritten_IsSaidBeforeMeasuring) {
    expectMistake({"--model", "phong", "--plot", "chart.pdf"}, ".svg or .png");
    expectMistake({"--model", "phong", "--plot", "/no/such/folder/chart.svg"}, "no folder");
}

TEST(Cost, PictureOfAnUnknownKindOrInTheWrongPlace_IsSaidBeforeMeasuring) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "taken.png");
    expectMistake({"--model", "phong", "--error-map", "map.tga"}, ".png or .jpg");
    expectMistake({"--model", "phong", "--error-map", (folder / "taken.png").string()},
                  "that of a folder");
    expectMistake({"--model", "phong", "--error-map", "/proc/map.png"}, "may not be written");
}

TEST(Cost, ErrorMap_MayBeAJpeg) {
    const TemporaryFolder folder;
    const auto file = folder / "errors.JPG";
    const Outcome outcome = cost({"--error-map", file.string()});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_GT(std::filesystem::file_size(file), 100u);
}

TEST(Cost, SizeThatTheDeviceCannotDraw_IsSaidBeforeMeasuring) {
    expectMistake({"--model", "phong", "--size", "99999x99999"},
                  "an image of 99999x99999 pixels cannot be drawn; expected 1 to");
    expectMistake({"--all-models", "--size", "99999x99999"}, "cannot be drawn");
    expectMistake({"--model", "phong", "--scaling", "--size", "99999x99999"}, "cannot be drawn");
}

TEST(Cost, Seconds_AreANumberAboveNothing) {
    for (const char* text : {"nan", "inf", "0", "-1", "soon"}) {
        expectMistake({"--model", "phong", "--seconds", text}, "expected seconds above 0");
    }
}

TEST(Cost, BadPresetAfterAGoodOne_IsSaidBeforeMeasuring) {
    const std::string good = std::string(PATINA_SOURCE_DIR) + "/presets/strauss/brass.patina.json";
    expectMistake({good, "/no/such/preset.patina.json"}, "preset.patina.json");
}

TEST(Cost, Budgets_AreNumbersOrFractions) {
    expectMistake({"--model", "phong", "--budget-ms", "nan"}, "not a budget");
    expectMistake({"--model", "phong", "--budget-ms", "-1"}, "milliseconds above 0");
    expectMistake({"--model", "phong", "--budget-error", "1/0"}, "1/255");
    const Outcome outcome = cost({"--budget-error", "1/2"});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
}

TEST(Cost, Interrupted_EndsAndSaysSo) {
    const Outcome outcome =
        interrupted({"cost", "--model", "he-torrance", "--size", "1024x1024", "--seconds", "600"});
    EXPECT_EQ(outcome.exitCode, 130) << outcome.err;
    EXPECT_NE(outcome.err.find("stopped"), std::string::npos) << outcome.err;
}

TEST(Cost, NothingToMeasure_IsAMistake) {
    EXPECT_EQ(patina({"cost"}).exitCode, 1);
}

} // namespace
} // namespace patina::tests::cost_test
