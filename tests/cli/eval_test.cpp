// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gtest/gtest.h>
#include <sstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/patina_program.h"
#include "measure/eval/eval_case.h"

namespace patina::tests::eval_test {
namespace {

using Json = nlohmann::json;

Outcome evalLines(const std::string& lines) {
    return patina(Start{.arguments = {"eval"}, .environment = {}, .input = lines});
}

/// The answer to one case.
Json answerTo(const Json& request) {
    return Json::parse(evalLines(request.dump() + "\n").out, nullptr, false);
}

std::string errorOf(const Json& request) {
    return answerTo(request).value("error", "");
}

Json facing(const std::string& model) {
    return {{"id", "a"}, {"model", model}, {"l", {0, 0, 1}}, {"v", {0, 0, 1}}};
}

TEST(EvalCommand, Fraction_HasSeventeenDigits) {
    const Outcome outcome = evalLines(R"({"id": 1, "fresnel": "schlick", "cos": 0.3})"
                                      "\n");
    const auto start = outcome.out.find("[0.") + 3;
    EXPECT_GE(outcome.out.find_first_not_of("0123456789", start) - start, 16u) << outcome.out;
}

TEST(EvalCommand, Id_ComesBackAsItWas) {
    for (const Json& id : {Json("x \"y\""), Json(7), Json(nullptr), Json({1, 2})}) {
        Json request = facing("lambert");
        request["id"] = id;
        EXPECT_EQ(answerTo(request).at("id"), id);
    }
}

TEST(EvalCommand, FloatOfAnEndOfARange_IsWithinIt) {
    Json request = facing("he-torrance");
    request["parameters"] = {{"tau", static_cast<double>(0.01F)}};
    EXPECT_EQ(errorOf(request), "");
    request["parameters"] = {{"tau", 0.0099}};
    EXPECT_NE(errorOf(request).find("outside its range"), std::string::npos);
}

TEST(EvalCommand, BrokenLine_KeepsItsId) {
    const Outcome outcome = evalLines(R"({"id": "far", "model": "phong", "l": [0, 0, 1e999]})"
                                      "\n");
    EXPECT_EQ(Json::parse(outcome.out)["id"], "far") << outcome.out;
}

TEST(EvalCommand, BadLine_MakesTheExitStatusOne) {
    EXPECT_EQ(evalLines("{}\n").exitCode, 1);
    EXPECT_EQ(evalLines("").exitCode, 0);
}

TEST(EvalCommand, Answers_ComeInTheOrderOfTheirLines) {
    std::string lines;
    for (int i = 0; i < 6; ++i) {
        Json request = facing(i % 2 == 0 ? "lambert" : "phong");
        request["id"] = i;
        request["precision"] = i % 3 == 0 ? "gpu" : "double";
        lines += request.dump() + "\n";
    }
    std::istringstream out(evalLines(lines).out);
    std::string line;
    for (int i = 0; i < 6; ++i) {
        ASSERT_TRUE(std::getline(out, line));
        EXPECT_EQ(Json::parse(line)["id"], i);
    }
}

TEST(EvalCommand, ManyLines_AreAnsweredInTheirOrder) {
    // More than are answered at a time, a bad one among them, shared out among all cores.
    constexpr int count = 40000;
    std::string lines;
    for (int i = 0; i < count; ++i) {
        lines += fmt::format("{{\"id\": {}, \"{}\": \"schlick\", \"cos\": {}}}\n", i,
                             i == 23456 ? "fresnell" : "fresnel", double(i) / count);
    }
    std::istringstream out(evalLines(lines).out);
    std::string line;
    for (int i = 0; i < count; ++i) {
        ASSERT_TRUE(std::getline(out, line)) << i;
        const Json answer = Json::parse(line);
        ASSERT_EQ(answer.at("id"), i);
        ASSERT_EQ(answer.contains("error"), i == 23456) << line;
    }
}

TEST(EvalCommand, OwnFrame_TurnsTheCase) {
    Json request = facing("lambert");
    request["n"] = {2, 0, 0};
    request["t"] = {1, 1, 0};
    request["l"] = {3, 0, 4};
    request["v"] = {1, 0, 0};
    request["parameters"] = {{"diffuse.color", {1, 1, 1}}};
    EXPECT_NEAR(answerTo(request).at("value")[0].get<double>(), 0.6, 1e-15);
}

TEST(EvalCommand, DoublePrecision_KeepsEveryDigitOfAParameter) {
    Json request = facing("lambert");
    request["parameters"] = {{"diffuse.color", {0.1, 0.2, 0.3}}};
    EXPECT_EQ(answerTo(request).at("value"), Json({0.1, 0.2, 0.3}));
}

TEST(EvalCommand, LibraryFunction_IsFoundByEitherSpelling) {
    const Json snake = answerTo({{"function", "ggx_d"}, {"arguments", {0.9, 0.3}}});
    const Json camel = answerTo({{"function", "ggxD"}, {"arguments", {0.9, 0.3}}});
    EXPECT_EQ(snake.at("value"), camel.at("value"));
    EXPECT_EQ(snake.at("value").size(), 1u);
}

TEST(EvalCommand, LibraryFunctionOnTheGpu_AgreesWithDouble) {
    Json request{{"function", "dielectric_reflectances"}, {"arguments", {0.5, 0.5, 1, 1.5}}};
    const Json exact = answerTo(request).at("value");
    request["precision"] = "gpu";
    const Json answer = answerTo(request).at("value");
    ASSERT_EQ(answer.size(), 2u);
    EXPECT_NEAR(answer[1].get<double>() / exact[1].get<double>(), 1.0, 1e-5);
}

TEST(EvalCommand, WrongNumberOfArguments_ShowsTheSignature) {
    EXPECT_NE(errorOf({{"function", "ggx_d"}, {"arguments", {1}}}).find("float alpha"),
              std::string::npos);
}

TEST(EvalCommand, ToneCurve_TakesTheLightThatItShows) {
    const Json curve{{"id", "reinhard"}, {"parameters", {{"white", 4}}}};
    const Json answer = answerTo({{"tone", curve}, {"radiance", {4, 4, 4}}});
    ASSERT_TRUE(answer.contains("value")) << answer;
    EXPECT_NEAR(answer.at("value")[0].get<double>(), 1.0, 1e-12); // the white of the curve
}

TEST(EvalCommand, Help_ShowsACaseOfEachKind) {
    const std::string help = patina({"eval", "--help"}).out;
    for (const BlockKind& kind : blockKinds()) {
        if (!evaluatedFunctions(kind).empty()) {
            EXPECT_NE(help.find(fmt::format("{{\"{}\":", kind.singular)), std::string::npos)
                << kind.singular;
        }
    }
}

TEST(EvalCommand, Light_AnswersWithItsDirection) {
    const Json answer = answerTo({{"light", {{"id", "directional"}}}, {"x", {0, 0, 0}}});
    EXPECT_EQ(answer.at("l").size(), 3u);
    EXPECT_EQ(answer.at("value"), Json({1, 1, 1}));
}

TEST(EvalCommand, Fog_AnswersWithTheShareThatIsLeft) {
    const Json answer =
        answerTo({{"fog", {{"id", "linear"}, {"parameters", {{"start", 0}}}}}, {"distance", 2.5}});
    EXPECT_EQ(answer.at("value"), Json({0.75}));
}

TEST(EvalCommand, Environment_AnswersWithWhatComesFromADirection) {
    const Json answer =
        answerTo({{"environment",
                   {{"id", "image"}, {"parameters", {{"intensity", 2}, {"tint", {1, 0.5, 1}}}}}},
                  {"direction", {0, 5, 0}},
                  {"picture", {0.25, 0.5, 0.75}}});
    EXPECT_EQ(answer.at("value"), Json({0.5, 0.5, 1.5}));
}

TEST(EvalCommand, EnvironmentWithoutAPicture_NeedsOnlyADirection) {
    const Json sky{{"environment", "sky"}, {"direction", {0, 1, 0}}};
    EXPECT_GT(answerTo(sky).at("value")[2].get<double>(), 0.0);
}

TEST(EvalCommand, Refraction_FollowsSnell) {
    const double sine = std::sqrt(0.75);
    const Json body{{"id", "solid-body"}, {"parameters", {{"index", 1.5}}}};
    Json request{{"refraction", body}, {"l", {sine, 0, 0.5}}, {"n", {0, 0, 1}}};
    const Json into = answerTo(request).at("value");
    EXPECT_NEAR(into[0].get<double>(), -sine / 1.5, 1e-12);
    EXPECT_NEAR(into[2].get<double>(), -std::sqrt(1.0 - 0.75 / 2.25), 1e-12);
    request["leaves"] = true;
    EXPECT_EQ(answerTo(request).at("value"), Json({0.0, 0.0, 0.0})) << "total reflection";
}

TEST(EvalCommand, Outline_AnswersWithTheWidthsOfAnEdge) {
    Json request{{"outline", {{"id", "ink-line"}, {"parameters", {{"width", 3}}}}}};
    EXPECT_EQ(answerTo(request).at("value"), Json({0.0, 0.0}));
    request["silhouette"] = true;
    request["dihedral"] = 1.5;
    EXPECT_EQ(answerTo(request).at("value"), Json({3.0, 1.5}));
}

TEST(EvalCommand, Transparency_AnswersWithHowMuchASurfaceCounts) {
    const Json request{{"transparency", "weighted"}, {"depth", 0.5}, {"opacity", 0.5}};
    EXPECT_NEAR(answerTo(request).at("value")[0].get<double>(), 0.25, 1e-12);
}

TEST(EvalCommand, Shadow_SaysWhyItHasNoValue) {
    EXPECT_NE(errorOf({{"shadow", "hard"}}).find("they read what is drawn"), std::string::npos);
}

TEST(EvalCommand, CalledFunction_AnswersWithItsOwnResult) {
    EXPECT_EQ(answerTo({{"fog", {{"id", "linear"}, {"parameters", {{"color", {0.25, 0.5, 0.75}}}}}},
                        {"call", "Color"}})
                  .at("value"),
              Json({0.25, 0.5, 0.75}));
    const Json body{{"id", "solid-body"}, {"parameters", {{"index", 1.5}}}};
    const Json mirrored{
        {"refraction", body}, {"call", "Mirrored"}, {"l", {0, 0, 1}}, {"n", {0, 0, 1}}};
    const Json share = answerTo(mirrored).at("value");
    ASSERT_EQ(share.size(), 1u);
    EXPECT_NEAR(share[0].get<double>(), 0.04, 1e-12);
    const Json left{
        {"refraction",
         {{"id", "solid-body"},
          {"parameters", {{"absorption.color", {0.5, 0.25, 1}}, {"absorption.distance", 2}}}}},
        {"call", "Left"},
        {"way", 4}};
    const Json rest = answerTo(left).at("value");
    EXPECT_NEAR(rest[0].get<double>(), 0.25, 1e-12);
    EXPECT_NEAR(rest[1].get<double>(), 0.0625, 1e-12);
    EXPECT_NEAR(rest[2].get<double>(), 1.0, 1e-12);
}

TEST(EvalCommand, UnknownCall_SaysWhatThereIs) {
    const std::string error =
        errorOf({{"refraction", "solid-body"}, {"call", "Mirored"}, {"way", 1}});
    EXPECT_NE(error.find("refractions have no function \"Mirored\""), std::string::npos) << error;
    EXPECT_NE(error.find("expected 'Mirrored'"), std::string::npos) << error;
    EXPECT_NE(errorOf({{"light", "point"}, {"call", "Color"}}).find("expected no \"call\""),
              std::string::npos);
    EXPECT_NE(errorOf({{"function", "sqr"}, {"arguments", {3}}, {"call", "Color"}})
                  .find("\"call\" means nothing here"),
              std::string::npos);
}

TEST(EvalCommand, PlaceOfAnotherFunction_MeansNothingToTheCalledOne) {
    const Json color{{"fog", "linear"}, {"call", "Color"}, {"distance", 1}};
    EXPECT_NE(errorOf(color).find("\"distance\" means nothing here"), std::string::npos);
    const Json left{{"refraction", "solid-body"}, {"call", "Left"}};
    EXPECT_NE(errorOf(left).find("there is no \"way\""), std::string::npos);
    EXPECT_NE(
        errorOf({{"refraction", "solid-body"}, {"call", "Left"}, {"way", -1}}).find("0 or more"),
        std::string::npos);
}

TEST(EvalCommand, FieldsOnTheGpu_AgreeWithDouble) {
    for (Json request :
         {Json{{"environment", "studio"}, {"direction", {0.3, 0.8, 0.1}}},
          Json{{"environment", "image"}, {"direction", {0, 0, 1}}, {"picture", {0.1, 0.2, 0.3}}},
          Json{{"refraction", "thin-pane"}, {"l", {0.3, 0.2, 0.8}}, {"n", {0, 0.1, 1}}},
          Json{{"refraction",
                {{"id", "solid-body"}, {"parameters", {{"index", 1.1}, {"dispersion", 1}}}}},
               {"l", {0.3, 0.2, 0.8}},
               {"n", {0, 0.1, 1}},
               {"channel", 2},
               {"leaves", true}},
          Json{{"outline", "ink-line"}, {"open", true}, {"dihedral", 0.2}},
          Json{{"transparency", "weighted"}, {"depth", 0.25}, {"opacity", 0.75}},
          Json{{"fresnel", "strauss"}, {"call", "Tint"}},
          Json{{"refraction", "solid-body"}, {"call", "Left"}, {"way", 0.5}}}) {
        const Json exact = answerTo(request).at("value");
        request["precision"] = "gpu";
        const Json drawn = answerTo(request).value("value", Json::array());
        ASSERT_EQ(drawn.size(), exact.size()) << request;
        for (std::size_t i = 0; i < exact.size(); ++i) {
            EXPECT_NEAR(drawn[i].get<double>(), exact[i].get<double>(), 1e-5) << request;
        }
    }
}

TEST(EvalCommand, FieldsOutsideTheirRange_AreErrors) {
    const Json interface{{"refraction", "solid-body"}, {"l", {0, 0, 1}}, {"n", {0, 0, 1}}};
    const auto errorWith = [](Json request, const char* key, const Json& value) {
        request[key] = value;
        return errorOf(request);
    };
    EXPECT_EQ(errorOf(interface), "");
    EXPECT_NE(errorWith(interface, "channel", 3).find("channel is 3"), std::string::npos);
    EXPECT_NE(errorWith(interface, "channel", 0.5).find("channel is 0.5"), std::string::npos);
    EXPECT_NE(errorWith(interface, "leaves", 1).find("true or false"), std::string::npos);
    EXPECT_NE(errorWith(interface, "n", {0, 0, -1}).find("the other side"), std::string::npos);
    EXPECT_NE(errorWith(interface, "side", 1).find("means nothing here"), std::string::npos);
    EXPECT_NE(errorOf({{"environment", "sky"}}).find("no \"direction\""), std::string::npos);
}

TEST(EvalCommand, UnknownNames_AreNamedInTheError) {
    EXPECT_NE(errorOf(facing("phongg")).find("'phong'"), std::string::npos);
    Json request = facing("phong");
    request["parameters"] = {{"shinyness", 3}};
    EXPECT_NE(errorOf(request).find("shinyness"), std::string::npos);
    request = facing("phong");
    request["colour"] = 1;
    EXPECT_NE(errorOf(request).find("colour"), std::string::npos);
}

TEST(EvalCommand, ValueOutsideItsRange_IsAnError) {
    Json request = facing("phong");
    request["parameters"] = {{"shininess", -1}};
    EXPECT_NE(errorOf(request).find("shininess"), std::string::npos);
}

TEST(EvalCommand, CosineOutsideItsRange_IsAnError) {
    for (const double c : {2.0, -1.5}) {
        EXPECT_NE(errorOf({{"fresnel", "schlick"}, {"cos", c}}).find("expected -1 .. 1"),
                  std::string::npos)
            << c;
    }
}

TEST(EvalCommand, NegativeDistance_IsAnError) {
    EXPECT_NE(errorOf({{"fog", "linear"}, {"distance", -1}}).find("expected 0 or more"),
              std::string::npos);
}

TEST(EvalCommand, BlockThatTheModelHasNoSlotFor_IsAnError) {
    Json request = facing("lambert");
    request["fresnel"] = "schlick";
    EXPECT_NE(errorOf(request).find("lambert has no slot for \"fresnel\""), std::string::npos);
    request["fresnel"] = nullptr;
    EXPECT_EQ(errorOf(request), "");
}

TEST(EvalCommand, ZeroVector_IsAnError) {
    Json request = facing("phong");
    request["v"] = {0, 0, 0};
    EXPECT_NE(errorOf(request).find("v "), std::string::npos);
}

TEST(EvalCommand, LengthOfADirection_DoesNotMatter) {
    Json request = facing("phong");
    for (const char* precision : {"double", "gpu"}) {
        request["precision"] = precision;
        request["n"] = {0.0, 0.6, 0.8};
        request["v"] = {0.0, 0.0, 1.0};
        const Json value = answerTo(request)["value"];
        for (const double length : {1e-300, 1e-38, 1e-31, 1e38, 1e300}) {
            request["n"] = {0.0, 0.6 * length, 0.8 * length};
            request["v"] = {0.0, 0.0, length};
            const Json scaled = answerTo(request)["value"];
            for (int i = 0; i < 3; ++i) {
                EXPECT_NEAR(scaled[i].get<double>(), value[i].get<double>(), 1e-6)
                    << precision << ", length " << length;
            }
        }
    }
}

TEST(EvalCommand, OpenSlot_IsEmptyOrFilledByTheGivenBlock) {
    const Json plain = answerTo(facing("lambert"));
    Json request = facing("lambert");
    request["specular"] = nullptr;
    EXPECT_EQ(answerTo(request)["value"], plain["value"]);
    request["specular"] = {{"id", "phong"}, {"parameters", {{"specular.color", {1, 0, 0}}}}};
    for (const char* precision : {"double", "gpu"}) {
        request["precision"] = precision;
        const Json value = answerTo(request)["value"];
        EXPECT_NEAR(value[0].get<double>(), plain["value"][0].get<double>() + 1.0, 1e-6);
        EXPECT_NEAR(value[1].get<double>(), plain["value"][1].get<double>(), 1e-6);
    }
}

TEST(EvalCommand, HighlightAlone_IsEvaluated) {
    const Json request = {{"specular", {{"id", "gaussian"}}}, {"l", {0, 0, 1}}, {"v", {0, 0, 1}}};
    EXPECT_EQ(answerTo(request)["value"][0], 0.5);
}

TEST(EvalCommand, Slot_IsFilledByItsDefaultOrTheGivenBlock) {
    const Json plain = answerTo(facing("cook-torrance"));
    Json request = facing("cook-torrance");
    request["fresnel"] = {{"id", "schlick"}};
    EXPECT_EQ(answerTo(request).at("value"), plain.at("value"));
    request["fresnel"] = {{"id", "schlick"}, {"parameters", {{"f0", {1, 1, 1}}}}};
    EXPECT_NE(answerTo(request).at("value"), plain.at("value"));
}

} // namespace
} // namespace patina::tests::eval_test
