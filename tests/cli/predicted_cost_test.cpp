// SPDX-License-Identifier: GPL-3.0-or-later
// What a material costs on graphics cards that are not here.
#include <algorithm>
#include <cmath>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/patina_program.h"
#include "measure/prediction/predicted_subject.h"
#include "measure/prediction/varying_loops.h"
#include "predict/family_compiler.h"

namespace patina::tests::predicted_cost_test {
namespace {

const std::string threeLights = shipped("presets/three-lights.patina-scene.json").string();

nlohmann::json predicted(std::vector<std::string> command) {
    command.emplace_back("--json");
    const Outcome outcome = patina(std::move(command));
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    return nlohmann::json::parse(outcome.out, nullptr, false);
}

/// The fragment stage of a model, exact, under three lights.
nlohmann::json stageOf(const std::string& model, const std::string& family) {
    const nlohmann::json json = predicted(
        {"cost", "--model", model, "--scene", threeLights, "--gpu", family, "--as-it-is"});
    return json.at("presets").at(0).at("ways").at(0).at("families").at(family);
}

TEST(PredictedCost, Table_SaysThatItIsPredictedForWhichCardsAndWhatIsLeftOut) {
    const Outcome outcome = patina({"cost", gold, "--gpu", "rdna2,gcn,rdna3"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    for (const char* word : {"exact", "facets=reduced", "RDNA 2", "GCN 4", "RDNA 3",
                             "predicted at 1080p", "Steam Deck", "Mesa", "left out", "amd.com"}) {
        EXPECT_NE(outcome.out.find(word), std::string::npos) << word << '\n' << outcome.out;
    }
}

TEST(PredictedCost, SameMaterial_CostsTheSameEachTime) {
    const std::vector<std::string> command{"cost",      gold,         "--gpu",
                                           "rdna2,gcn", "--as-it-is", "--json"};
    const Outcome first = patina(command);
    ASSERT_EQ(first.exitCode, 0) << first.err;
    EXPECT_EQ(first.out, patina(command).out);
}

TEST(PredictedCost, DearerModels_TakeMoreInstructionsAndCycles) {
    const nlohmann::json phong = stageOf("phong", "rdna2");
    const nlohmann::json cookTorrance = stageOf("cook-torrance", "rdna2");
    const nlohmann::json strauss = stageOf("strauss", "rdna2");
    for (const char* number : {"instructions", "cycles"}) {
        EXPECT_LT(phong.at(number).get<double>(), cookTorrance.at(number).get<double>());
        EXPECT_LT(cookTorrance.at(number).get<double>(), strauss.at(number).get<double>());
    }
}

/// Returns the numbers in a text.
std::vector<double> numbersIn(const std::string& text) {
    std::vector<double> numbers;
    static const std::regex number("[0-9]+");
    for (std::sregex_iterator at(text.begin(), text.end(), number), end; at != end; ++at) {
        numbers.push_back(std::stod(at->str()));
    }
    return numbers;
}

/// MaterialX's default OpenPBR material is 3144 instructions under direct lights, by the same
/// driver. The page says what the preset of that look takes.
TEST(PredictedCost, OpenPbrsLook_IsAQuarterOfItsInstructionsAndAsThePageSays) {
    const nlohmann::json json = predicted(
        {"cost", shipped("presets/cook-torrance/openpbr-default.patina.json").string(), "--scene",
         threeLights, "--set", "scene.ambient=0,0,0", "--gpu", "gcn,rdna2,rdna3", "--as-it-is"});
    const auto& families = json.at("presets").at(0).at("ways").at(0).at("families");
    const std::string page = readFile(shipped("docs/design/predicted-cost.md"));
    const std::size_t row = page.find("| the preset |");
    ASSERT_NE(row, std::string::npos);
    const std::vector<double> stated = numbersIn(page.substr(row, page.find('\n', row) - row));
    ASSERT_GE(stated.size(), 6u);
    std::size_t next = 0;
    for (const char* family : {"gcn", "rdna2", "rdna3"}) {
        const auto& stage = families.at(family);
        EXPECT_LE(stage.at("instructions").get<double>(), 3144.0 / 4.0) << family;
        EXPECT_LE(stage.at("vgprs").get<double>(), 40.0) << family;
        EXPECT_NEAR(stage.at("instructions").get<double>() / stated[next++], 1.0, 0.02) << family;
        EXPECT_NEAR(stage.at("vgprs").get<double>() / stated[next++], 1.0, 0.1) << family;
    }
}

TEST(PredictedCost, OfAllModels_HasEachModelOnce) {
    const nlohmann::json json =
        predicted({"cost", "--all-models", "--scene", threeLights, "--gpu", "rdna1"});
    std::vector<std::string> models;
    for (const auto& model : json.at("models")) {
        models.push_back(model.at("model"));
        EXPECT_GT(model.at("families").at("rdna1").at("instructions").get<int>(), 100)
            << models.back();
    }
    std::ranges::sort(models);
    EXPECT_GE(models.size(), 20u);
    EXPECT_EQ(std::ranges::adjacent_find(models), models.end());
}

TEST(PredictedCost, Csv_HasALineForEachCardWithTheNumbersOfJson) {
    const std::vector<std::string> command{"cost",      "--model", "lambert",   "--scene",
                                           threeLights, "--gpu",   "rdna2,gcn", "--as-it-is"};
    std::vector<std::string> asCsv = command;
    asCsv.emplace_back("--csv");
    const Outcome outcome = patina(asCsv);
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const nlohmann::json families =
        predicted(command).at("presets").at(0).at("ways").at(0).at("families");
    std::istringstream stream(outcome.out);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) {
        lines.push_back(line);
    }
    ASSERT_EQ(lines.size(), 5u) << outcome.out;
    EXPECT_EQ(lines[0], "preset,levels,family,card,instructions,vgprs,sgprs,spills,waves,loops,"
                        "counted_rounds,cycles,latency,milliseconds,problem");
    EXPECT_TRUE(lines[1].starts_with("\"lambert\",\"exact\",rdna2,\"Steam Deck\"," +
                                     families.at("rdna2").at("instructions").dump() + ','))
        << lines[1];
    EXPECT_TRUE(lines[4].starts_with("\"lambert\",\"exact\",gcn,\"Radeon RX 580\",")) << lines[4];
}

/// A card's milliseconds: 32400 waves of 64 pixels, shared by 72 x 2 SIMD units at 2015 MHz.
TEST(PredictedCost, Milliseconds_FollowFromCyclesUnitsAndClock) {
    const nlohmann::json stage = stageOf("phong", "rdna2");
    const double expected =
        stage.at("cycles").get<double>() * 32400.0 / (72.0 * 2.0 * 2015.0 * 1e3);
    EXPECT_NEAR(stage.at("milliseconds").at("Radeon RX 6800 XT").get<double>(), expected,
                1e-6 * expected); // JSON has seven digits
}

/// A chart for a card: its times are those that --gpu predicts, its errors those that are measured
/// here, and a budget is of both.
nlohmann::json chartFor(std::vector<std::string> more) {
    std::vector<std::string> command{"cost",   "--model", "phong",     "--scene", threeLights,
                                     "--size", "32x32",   "--seconds", "2"};
    command.insert(command.end(), more.begin(), more.end());
    return predicted(command).at(0);
}

TEST(PredictedCost, ChartOfACard_HasItsMillisecondsAndMeasuredErrors) {
    const nlohmann::json chart = chartFor({"--card", "6800 xt", "--at", "1440p"});
    EXPECT_EQ(chart.at("predictedFor"), "Radeon RX 6800 XT (RDNA 2)");
    EXPECT_EQ(chart.at("size"), (nlohmann::json{2560, 1440}));
    const nlohmann::json at1080p = stageOf("phong", "rdna2").at("milliseconds");
    const auto& points = chart.at("points");
    ASSERT_GE(points.size(), 3u);
    EXPECT_NEAR(points.at(0).at("milliseconds").at("median").get<double>(),
                at1080p.at("Radeon RX 6800 XT").get<double>() * 2560.0 * 1440.0 / 2073600.0, 1e-5);
    const double exactError = points.at(0).at("error").at("p99");
    EXPECT_LE(exactError, 1e-6);
    for (std::size_t i = 1; i < points.size(); ++i) {
        EXPECT_LT(points.at(i).at("ratio").at("median"), 1.0) << points.at(i).dump();
        EXPECT_GT(points.at(i).at("error").at("p99"), exactError) << points.at(i).dump();
    }
}

/// The middle card stands for a family that is named in its place.
TEST(PredictedCost, BudgetOfACardOrAFamily_PicksWhatKeepsTimeAndErrorThere) {
    const nlohmann::json free = chartFor({"--card", "RDNA 2"});
    EXPECT_EQ(free.at("predictedFor"), "Radeon RX 6600 (RDNA 2)");
    const double exact = free.at("points").at(0).at("milliseconds").at("median");
    const std::string all = std::to_string(1.01 * exact);
    const nlohmann::json roomy =
        chartFor({"--gpu", "rdna2", "--budget-ms", all, "--budget-error", "1/255"});
    EXPECT_EQ(roomy.at("predictedFor"), "Radeon RX 6600 (RDNA 2)");
    EXPECT_EQ(roomy.at("budget"), (nlohmann::json{{"fits", true}, {"index", 0}}));
    const std::string less = std::to_string(0.99 * exact);
    const nlohmann::json tight =
        chartFor({"--card", "6600", "--budget-ms", less, "--budget-error", "1/255"});
    EXPECT_EQ(tight.at("budget").at("fits"), true);
    const auto& bought = tight.at("points").at(tight.at("budget").at("index").get<std::size_t>());
    EXPECT_LE(bought.at("milliseconds").at("median").get<double>(), 0.99 * exact);
    EXPECT_LE(bought.at("error").at("p99").get<double>(), 1.0 / 255.0);
}

TEST(PredictedCost, CardThatNobodyKnowsOrTwoHave_IsRefusedWithTheKnownOnes) {
    for (const char* name : {"voodoo", "radeon"}) {
        const Outcome outcome = patina({"cost", gold, "--card", name});
        EXPECT_NE(outcome.exitCode, 0);
        EXPECT_NE(outcome.err.find("Steam Deck"), std::string::npos) << outcome.err;
    }
    const Outcome size = patina({"cost", gold, "--card", "deck", "--at", "large"});
    EXPECT_NE(size.err.find("1440p"), std::string::npos) << size.err;
    const Outcome both = patina({"cost", gold, "--card", "deck", "--gpu", "rdna2"});
    EXPECT_EQ(both.exitCode, 1);
    EXPECT_NE(both.err.find("not both"), std::string::npos) << both.err;
    const Outcome several = patina({"cost", gold, "--gpu", "rdna2,gcn", "--budget-ms", "1"});
    EXPECT_NE(several.err.find("for one graphics card"), std::string::npos) << several.err;
}

/// The compiler does not unroll the loops over 8, 16 and 48 places of a soft shadow's search, and
/// twice as many of its edge, and takes each to run 8 times.
TEST(PredictedCost, RoundsOfALoopThatAreAConstant_CountEach) {
    const auto cyclesWith = [](const std::string& quality) {
        const nlohmann::json json =
            predicted({"cost", "--model", "lambert", "--set", "shadow.samples=" + quality, "--gpu",
                       "rdna2", "--as-it-is"});
        const auto& stage = json.at("presets").at(0).at("ways").at(0).at("families").at("rdna2");
        EXPECT_EQ(stage.at("loops"), 0);
        return stage.at("cycles").get<double>();
    };
    const double coarse = cyclesWith("coarse");
    const double normal = cyclesWith("normal");
    const double fine = cyclesWith("fine");
    EXPECT_GT(normal, 1.2 * coarse);
    EXPECT_NEAR((fine - normal) / (normal - coarse), 4.0, 0.02) << "96 more rounds, and 24";
}

/// A program with so many rounds of loops within each other, of which the innermost has a body that
/// is too long to be written out so often.
ProgramText withLoops(const std::vector<int>& rounds) {
    std::string loops;
    std::string ends;
    for (std::size_t i = 0; i < rounds.size(); ++i) {
        const std::string name = "n" + std::to_string(i);
        loops += "for (int " + name + " = 0; " + name + " < " + std::to_string(rounds[i]) + "; ++" +
                 name + ") {\n";
        ends += "x += fract(x.yzxw * " + std::to_string(i) + ".3); }\n";
    }
    std::string body;
    for (int i = 0; i < 48; ++i) {
        body += "x = fract(x.wxyz * x + " + std::to_string(i) + ".7); x = sqrt(x + 0.1);\n";
    }
    return {"#version 410 core\nin vec2 corner;\nout vec4 at;\nvoid main() {\n"
            "    at = corner.xyyx;\n    gl_Position = vec4(corner, 0.0, 1.0);\n}\n",
            "#version 410 core\nin vec4 at;\nout vec4 color;\nvoid main() {\nvec4 x = at;\n" +
                loops + body + ends + "color = x;\n}\n"};
}

/// What 1000 more rounds of the body take is the same in a loop within another and in one within
/// two, and about the same in a loop of its own: one round of that is told from a program without a
/// loop, which the driver computes a little faster.
TEST(PredictedCost, RoundsOfLoopsInLoops_CountForEachRoundAround) {
    const std::vector<std::pair<std::vector<int>, std::vector<int>>> pairs{
        {{20, 50}, {20, 100}}, {{10, 20, 25}, {10, 20, 30}}, {{1000}, {2000}}};
    std::vector<ProgramText> texts;
    for (const auto& [few, more] : pairs) {
        texts.push_back(withLoops(few));
        texts.push_back(withLoops(more));
    }
    const auto compiled = compileForFamilies(gpuFamiliesIn("rdna2").value(), texts, {});
    ASSERT_TRUE(compiled) << compiled.error().text();
    const auto stage = [&compiled](std::size_t i) {
        return compiled->programs.at(i)->at("rdna2").fragment;
    };
    const auto thousand = [&](std::size_t pair) {
        EXPECT_EQ(stage(2 * pair).loops + stage(2 * pair + 1).loops, 0) << pair;
        return stage(2 * pair + 1).cycles - stage(2 * pair).cycles;
    };
    const double inOne = thousand(0);
    EXPECT_GT(inOne, 1000.0 * 48 * 4);
    EXPECT_NEAR(thousand(1) / inOne, 1.0, 0.01);
    EXPECT_NEAR(thousand(2) / inOne, 1.0, 0.08);
}

/// Rays that see the environment are as many as a frame takes.
TEST(PredictedCost, RoundsThatNobodyKnows_AreSaidToBeGuessed) {
    const std::string gem = shipped("presets/cook-torrance/garnet.patina.json").string();
    const nlohmann::json refracting = predicted({"cost", gem, "--gpu", "rdna2", "--as-it-is"});
    EXPECT_GT(
        refracting.at("presets").at(0).at("ways").at(0).at("families").at("rdna2").at("loops"), 0);
    EXPECT_EQ(stageOf("phong", "rdna2").at("loops"), 0);
}

/// He-Torrance's series has as many terms as the directions call for.
/// Four texture units take 16 clocks for 64 lanes, which four SIMD units of GCN share, and two of
/// RDNA. Eight more look-ups need some instructions of their own.
TEST(PredictedCost, LookUpsOfTexels_TakeTheTextureUnitsThatSimdUnitsShare) {
    const auto texts = [](int lookUps) {
        const std::string vertex =
            "#version 410 core\nin vec2 corner;\nout vec2 at;\nvoid main() {\n"
            "    at = corner;\n    gl_Position = vec4(corner, 0.0, 1.0);\n}\n";
        std::string sum;
        for (int i = 0; i < lookUps; ++i) {
            sum += "    color += texelFetch(picture, ivec2(at) + ivec2(" + std::to_string(3 * i) +
                   ", 1), 0);\n";
        }
        return ProgramText{vertex, "#version 410 core\nuniform sampler2D picture;\nin vec2 at;\n"
                                   "out vec4 color;\nvoid main() {\n    color = vec4(0.0);\n" +
                                       sum + "}\n"};
    };
    const auto families = gpuFamiliesIn("gcn,rdna2").value();
    const auto compiled = compileForFamilies(families, {texts(2), texts(10)}, {});
    ASSERT_TRUE(compiled) << compiled.error().text();
    for (const GpuFamily* family : families) {
        ASSERT_TRUE(compiled->programs[0] && compiled->programs[1]);
        const double more = compiled->programs[1]->at(family->id).fragment.cycles -
                            compiled->programs[0]->at(family->id).fragment.cycles;
        const double inTextureUnits = 8.0 * 16.0 * family->simdsPerUnit;
        EXPECT_GE(more, inTextureUnits) << family->id;
        EXPECT_LE(more, 1.7 * inTextureUnits) << family->id;
    }
}

TEST(VaryingLoops, RoundsOfASeries_AreFewerWhereItIsShortened) {
    const Catalog catalog = loadCatalog(std::vector<BlockRoot>{{shipped("shaders"), true}});
    Material material = defaultMaterial(*catalog.find(kinds::models, "he-torrance"));
    const auto roundsOf = [&](const std::string& series) {
        material.accuracy["series"] = series;
        const auto loops = varyingLoops(material, catalog);
        const auto varying = std::ranges::find(loops, true, &VaryingLoop::isVarying);
        EXPECT_EQ(loops.size(), 2u) << "the series, and the loop over the channels around it";
        return varying == loops.end() ? 0.0 : varying->rounds;
    };
    const double full = roundsOf("full");
    EXPECT_GT(full, roundsOf("medium"));
    EXPECT_GT(roundsOf("medium"), roundsOf("short"));
    EXPECT_LE(full, 100.0) << "the largest number of terms that it sums";
    EXPECT_TRUE(
        varyingLoops(defaultMaterial(*catalog.find(kinds::models, "phong")), catalog).empty());
}

/// A grating's loops ask for its value of orders, which no compiler knows.
TEST(VaryingLoops, RoundsOfAValue_CountEach) {
    const auto cyclesWith = [](int orders) {
        const nlohmann::json json = predicted(
            {"cost", "--model", "grating", "--set", "orders=" + std::to_string(orders), "--scene",
             threeLights, "--set", "scene.ambient=0,0,0", "--gpu", "rdna2", "--as-it-is"});
        const auto& stage = json.at("presets").at(0).at("ways").at(0).at("families").at("rdna2");
        EXPECT_EQ(stage.at("loops"), 0);
        EXPECT_EQ(stage.at("countedRounds"), 2.0 * orders) << "two loops";
        return stage.at("cycles").get<double>();
    };
    const double one = cyclesWith(1);
    const double three = cyclesWith(3);
    const double seven = cyclesWith(7);
    EXPECT_GT(three, 1.05 * one);
    EXPECT_NEAR((seven - three) / (three - one), 2.0, 0.02);
}

/// All rounds are written out in the place of two and three of them.
TEST(VaryingLoops, RoundsOfASeries_CostWhatTheyDoWrittenOut) {
    const auto catalog = std::make_shared<const Catalog>(
        loadCatalog(std::vector<BlockRoot>{{shipped("shaders"), true}}));
    Scene scene;
    Material& material = scene.objects.emplace_back().material;
    material = defaultMaterial(*catalog->find(kinds::models, "he-torrance"));
    material.accuracy["series"] = "short";
    scene.lights.emplace_back().block.id = "directional";
    const MeshSource none = [](const Object&) { return MeshView{}; };
    const auto texts = surfaceTexts({scene, 0, none, catalog}, {scene});
    ASSERT_TRUE(texts) << patina::text(texts.error());
    const auto families = gpuFamiliesIn("rdna2").value();
    const auto predicted = compiledSurfaces(*texts, *catalog, families, {});
    ASSERT_TRUE(predicted) << predicted.error().text();
    const auto loops = varyingLoops(material, *catalog);
    std::vector<int> rounds;
    for (const VaryingLoop& loop : loops) {
        rounds.push_back(static_cast<int>(std::round(loop.rounds)));
    }
    const auto whole = withRounds(texts->front().text.fragment, loops, rounds);
    ASSERT_TRUE(whole);
    const auto written = compileForFamilies(families, {{texts->front().text.vertex, *whole}}, {});
    ASSERT_TRUE(written && written->programs.front());
    const StageStatistics& got = predicted->programs.front()->at("rdna2").fragment;
    EXPECT_GT(got.countedRounds, 3.0) << "of a series for each of three wavelengths";
    const StageStatistics& right = written->programs.front()->at("rdna2").fragment;
    EXPECT_EQ(got.loops, 0);
    EXPECT_NEAR(got.cycles / right.cycles, 1.0, 0.05);
}

TEST(VaryingLoops, WrittenOut_HaveSoManyRounds) {
    const std::string text =
        "float f(float x) {\n    for (int i = 0; i < 3; ++i) {\n        x += "
        "1.0;\n    }\n    for (int j = 0; j < int(x); ++j)\n        x *= 2.0;\n"
        "    return x;\n}\n";
    const std::vector<VaryingLoop> loops{{"f", 1, 5.0}};
    const std::vector<int> twice{2};
    const auto written = withRounds(text, loops, twice);
    ASSERT_TRUE(written);
    EXPECT_NE(written->find("{ int j = 0; x *= 2.0; ++j; x *= 2.0; }"), std::string::npos)
        << *written;
    EXPECT_NE(written->find("for (int i = 0; i < 3; ++i)"), std::string::npos) << *written;
    const std::vector<VaryingLoop> absent{{"f", 2, 5.0}};
    EXPECT_FALSE(withRounds(text, absent, twice));
}

TEST(PredictedCost, OfEffects_IsWhatTheShaderHasMoreWithThem) {
    const nlohmann::json json = predicted({"effects", gold, "--scene", threeLights, "--fog",
                                           "height", "--gpu", "rdna2", "--no-cost"});
    const auto& whole = json.at("predicted").at("families").at("rdna2");
    double sum = 0.0;
    int counted = 0;
    for (const auto& effect : json.at("effects")) {
        if (effect.at("removable").get<bool>() && effect.at("within").get<std::string>().empty()) {
            sum += effect.at("predicted").at("rdna2").at("instructions").get<double>();
            ++counted;
        }
    }
    EXPECT_GE(counted, 2) << "the model with its lights, and the fog";
    EXPECT_GT(sum, 0.5 * whole.at("instructions").get<double>());
    const auto fog = std::ranges::find_if(json.at("effects"), [](const nlohmann::json& effect) {
        return effect.at("effect").get<std::string>().starts_with("fog");
    });
    ASSERT_NE(fog, json.at("effects").end());
    const double cycles = fog->at("predicted").at("rdna2").at("cycles");
    EXPECT_GT(cycles, 0.0);
    EXPECT_NEAR(
        fog->at("predicted").at("rdna2").at("milliseconds").at("Radeon RX 6800 XT").get<double>(),
        cycles * 32400.0 / (72.0 * 2.0 * 2015.0 * 1e3), 1e-9);
}

TEST(PredictedCost, TableOfEffects_HasMillisecondsOfCardsAndTellsWhyARowHasNone) {
    const Outcome outcome = patina({"effects", "--model", "he-torrance", "--scene", threeLights,
                                    "--gpu", "rdna2", "--no-cost"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    for (const char* words : {"predicted for RDNA 2, Steam Deck", " ms ", "at 1080p Steam Deck",
                              "cannot be left out"}) {
        EXPECT_NE(outcome.out.find(words), std::string::npos) << words << '\n' << outcome.out;
    }
}

TEST(PredictedCost, OfFunctions_IsWhatTheStageHasMoreWithThem) {
    const nlohmann::json json = predicted({"effects", gold, "--scene", threeLights, "--light",
                                           "directional", "--gpu", "rdna2", "--source"});
    const std::string text = json.at("fragment");
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) {
        lines.push_back(line);
    }
    int largest = 0;
    for (const auto& function : json.at("functions")) {
        const std::string name = function.at("function");
        EXPECT_NE(lines.at(function.at("line").get<std::size_t>() - 1).find(name),
                  std::string::npos)
            << name;
        const int saved = function.at("families").at("rdna2").at("instructions");
        EXPECT_GE(saved, 0) << name;
        largest = name == "cookTorrance" ? saved : largest;
    }
    const nlohmann::json whole = predicted({"cost", gold, "--scene", threeLights, "--light",
                                            "directional", "--gpu", "rdna2", "--as-it-is"});
    const int all =
        whole.at("presets")[0].at("ways")[0].at("families").at("rdna2").at("instructions");
    EXPECT_GT(largest, all / 3) << "the model takes much of " << all;
    EXPECT_LT(largest, all);
}

TEST(PredictedCost, OfFunctions_StandsInAMarginBesideThem) {
    const Outcome shown = patina(
        {"effects", "--model", "phong", "--scene", threeLights, "--gpu", "rdna2", "--source"});
    const std::size_t headline = shown.out.find("// most registers: ");
    ASSERT_NE(headline, std::string::npos);
    const std::string line = shown.out.substr(headline, shown.out.find('\n', headline) - headline);
    EXPECT_TRUE(line.ends_with(" phong()")) << line << ", and not a pass without which all goes";
    EXPECT_NE(shown.out.find(" VGPRs "), std::string::npos);
    EXPECT_NE(shown.out.find(" | vec3 phong("), std::string::npos);
}

TEST(PredictedCost, UnknownFamily_IsRefusedWithTheKnownOnes) {
    const Outcome outcome = patina({"cost", gold, "--gpu", "rdna2,voodoo"});
    EXPECT_NE(outcome.exitCode, 0);
    EXPECT_NE(outcome.err.find("\"voodoo\""), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("rdna3"), std::string::npos) << outcome.err;
}

TEST(PredictedCost, MissingDriver_SaysWhatToInstall) {
    const Outcome outcome = patina(Start{.arguments = {"cost", gold, "--gpu", "rdna2"},
                                         .environment = {{"VK_DRIVER_FILES", "/nowhere.json"}},
                                         .input = {}});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_NE(outcome.err.find("mesa-vulkan-drivers"), std::string::npos) << outcome.err;
}

/// A compiler written as a shell script; it has answered with its driver when it does the rest.
CompiledForFamilies compiledBy(const std::string& rest, FamilyCompilerOptions options = {}) {
    const TemporaryFolder folder;
    options.program = folder / "compiler";
    writeFile(options.program, "#!/bin/sh\necho '{\"driver\":\"test\"}'\n" + rest + "\n");
    std::filesystem::permissions(options.program, std::filesystem::perms::owner_all);
    const auto compiled =
        compileForFamilies(*gpuFamiliesIn("rdna2"), {{"first", ""}, {"second", ""}}, options);
    EXPECT_TRUE(compiled) << compiled.error().text();
    return compiled.value_or(CompiledForFamilies());
}

TEST(PredictedCost, ManifestThatNamesNoDriver_IsTold) {
    const TemporaryFolder folder;
    const std::string manifest = folder / "radeon_icd.json";
    writeFile(manifest, "");
    const Outcome outcome = patina(Start{.arguments = {"cost", gold, "--gpu", "rdna2"},
                                         .environment = {{"VK_DRIVER_FILES", manifest}},
                                         .input = {}});
    EXPECT_NE(outcome.err.find("\"" + manifest + "\" names no Vulkan driver that can be loaded"),
              std::string::npos)
        << outcome.err;
}

TEST(FamilyCompiler, ProgramThatEndsIt_IsAnErrorOfThatProgramOnly) {
    const CompiledForFamilies compiled =
        compiledBy("grep -q first && kill -9 $$\necho '{\"families\":{}}'");
    ASSERT_EQ(compiled.programs.size(), 2u);
    EXPECT_FALSE(compiled.programs[0]);
    EXPECT_TRUE(compiled.programs[1]);
}

/// Each of the two scripts is given a half: it answers with the place of each program in its half.
TEST(FamilyCompiler, ProgramsSharedByTwo_AreInTheOrderThatTheyWereGivenIn) {
    const TemporaryFolder folder;
    FamilyCompilerOptions options;
    options.processes = 2;
    options.program = folder / "compiler";
    writeFile(options.program, "#!/bin/sh\necho '{\"driver\":\"test\"}'\n"
                               "grep -o 'program[0-9][0-9]*' | while read -r "
                               "name; do echo \"{\\\"error\\\":\\\"$name of $$\\\"}\"; done\n");
    std::filesystem::permissions(options.program, std::filesystem::perms::owner_all);
    std::vector<ProgramText> programs;
    for (int i = 0; i < 16; ++i) {
        programs.push_back({"program" + std::to_string(i), ""});
    }
    double share = 0.0;
    options.onProgress = [&share](double now) { share = now; };
    const auto compiled = compileForFamilies(*gpuFamiliesIn("rdna2"), programs, options);
    ASSERT_TRUE(compiled);
    std::set<std::string> processes;
    for (std::size_t i = 0; i < programs.size(); ++i) {
        ASSERT_FALSE(compiled->programs[i]);
        const std::string told = compiled->programs[i].error().problem;
        EXPECT_TRUE(told.starts_with(programs[i].vertex + " of ")) << told;
        processes.insert(told.substr(told.rfind(' ')));
    }
    EXPECT_EQ(processes.size(), 2u);
    EXPECT_EQ(share, 1.0);
}

TEST(FamilyCompiler, ProgramThatTakesTooLong_IsEnded) {
    FamilyCompilerOptions options;
    options.secondsEach = 0.02;
    const CompiledForFamilies compiled = compiledBy("exec sleep 60", options);
    ASSERT_EQ(compiled.programs.size(), 2u);
    EXPECT_NE(compiled.programs[0].error().problem.find("too long"), std::string::npos);
}

TEST(FamilyCompiler, TextThatDoesNotCompile_IsAnErrorWithTheCompilersWords) {
    const auto compiled = compileForFamilies(*gpuFamiliesIn("rdna2"), {{"void main() {", "x"}}, {});
    ASSERT_TRUE(compiled) << compiled.error().text();
    ASSERT_FALSE(compiled->programs.at(0));
    EXPECT_NE(compiled->programs.at(0).error().problem.find("syntax error"), std::string::npos)
        << compiled->programs.at(0).error().problem;
}

} // namespace
} // namespace patina::tests::predicted_cost_test
