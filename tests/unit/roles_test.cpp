// SPDX-License-Identifier: GPL-3.0-or-later
// What the program reads of a block is named by roles, and a wrong one is told where it stands.
#include <regex>

#include <gtest/gtest.h>

#include "catalog_fixture.h"

namespace patina::roles_test {
namespace {

nlohmann::json number(const std::string& id, const std::string& role) {
    nlohmann::json parameter{{"id", id},     {"label", "L"}, {"type", "float"},
                             {"default", 1}, {"min", 0},     {"max", 8}};
    if (!role.empty()) {
        parameter["role"] = role;
    }
    return parameter;
}

using Parameters = std::vector<nlohmann::json>;

Catalog withParameters(const std::string& kind, const Parameters& parameters) {
    tests::BlockFolder folder;
    nlohmann::json descriptor = tests::plainDescriptor("own");
    descriptor["parameters"] = parameters;
    folder.add(kind, descriptor);
    return folder.load();
}

std::string mistakes(const std::string& kind, const Parameters& parameters) {
    return text(withParameters(kind, parameters).errors);
}

bool isTold(const std::string& mistakes, const std::string& problem) {
    return mistakes.find(problem) != std::string::npos &&
           std::regex_search(mistakes, std::regex(R"(own\.json:\d+:\d+: )"));
}

TEST(Roles, OfParametersByAnyName_AreFound) {
    const Catalog catalog = withParameters("outline", {number("thickness", "width")});
    EXPECT_TRUE(catalog.errors.empty()) << text(catalog.errors);
    EXPECT_EQ(catalog.blocks.front().withRole(roles::width)->id, "thickness");
}

TEST(Roles, ThatNoParameterHas_AreNull) {
    const Catalog catalog = withParameters("outline", {number("width", "")});
    EXPECT_EQ(catalog.blocks.front().withRole(roles::width), nullptr);
}

TEST(Roles, ThatTheKindDoesNotKnow_AreMistakes) {
    const std::string told = mistakes("outline", {number("thickness", "widht")});
    EXPECT_TRUE(isTold(told, "outlines have no role \"widht\"")) << told;
    EXPECT_NE(told.find("width"), std::string::npos) << told;
    EXPECT_TRUE(isTold(mistakes("specular", {number("thickness", "width")}),
                       "highlights have no role \"width\""));
}

nlohmann::json state(const std::string& role, const std::string& choice, bool isCompiled) {
    nlohmann::json parameter{{"id", "state"},  {"label", "L"},
                             {"type", "enum"}, {"default", choice},
                             {"role", role},   {"values", {{{"id", choice}, {"label", "L"}}}}};
    if (isCompiled) {
        parameter["compiled"] = true;
    }
    return parameter;
}

TEST(Roles, OfAPassesState_AreToldWhatIsWrong) {
    EXPECT_TRUE(isTold(mistakes("pass", {state("blend", "overlay", true)}),
                       "\"overlay\" is no choice of the role \"blend\""));
    EXPECT_TRUE(isTold(mistakes("pass", {state("blend", "multiply", false)}),
                       "the \"blend\" of a pass is part of its program"));
    EXPECT_TRUE(isTold(mistakes("pass", {state("depthTest", "surfaces", true)}),
                       "without depths nothing can be tested by them"));
    EXPECT_TRUE(isTold(mistakes("pass", {number("share", "blendAmount")}), "an amount is a share"));
}

TEST(Roles, OfParametersOfAnotherType_AreMistakes) {
    EXPECT_TRUE(isTold(mistakes("fog", {number("density", "color")}),
                       "a parameter of type float cannot be the \"color\""));
}

TEST(Roles, ThatTwoParametersHave_AreMistakesWhereOneIsRead) {
    const std::string told =
        mistakes("refraction", {number("bending", "index"), number("other", "index")});
    EXPECT_TRUE(isTold(told, "\"bending\" is the \"index\" already")) << told;
    EXPECT_EQ(mistakes("outline", {number("outer", "width"), number("inner", "width")}), "");
}

TEST(Roles, ThatEveryBlockOfTheKindHas_AreMissedWhereTheParametersStand) {
    const std::string told = mistakes("refraction", {number("index", "")});
    EXPECT_TRUE(isTold(told, "no parameter is the \"index\", which all refractions have")) << told;
}

TEST(Roles, OfEnumsThatOfferSomethingElse_AreMistakesAtTheChoice) {
    const auto behind = nlohmann::json::parse(R"({"id": "behind", "label": "B", "type": "enum",
        "role": "background", "default": "sharp",
        "values": [{"id": "sharp", "label": "S"}, {"id": "gone", "label": "G"}]})");
    const std::string told = mistakes("environment", Parameters{behind});
    EXPECT_TRUE(isTold(told, "\"gone\" is no choice of the role \"background\"")) << told;
    EXPECT_EQ(told.find("\"sharp\" is no choice"), std::string::npos) << told;
}

} // namespace
} // namespace patina::roles_test
