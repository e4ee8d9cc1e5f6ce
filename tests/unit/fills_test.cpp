// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include "catalog/fills.h"
#include "catalog_fixture.h"
#include "material/block_values.h"
#include "material/material.h"

namespace patina::fills_test {
namespace {

const Catalog& fillCatalog() {
    static const Catalog shipped = loadCatalog(
        std::vector{BlockRoot{std::filesystem::path(PATINA_SOURCE_DIR) / "shaders", true}});
    return shipped;
}

const Block& conductor() {
    return *fillCatalog().find("fresnel", "conductor");
}

const Parameter& metal() {
    return *conductor().parameter("metal");
}

const Value& filledBy(const char* choice, const char* id) {
    const auto found = std::find_if(metal().values.begin(), metal().values.end(),
                                    [&](const EnumValue& value) { return value.id == choice; });
    return found->fills.at(id);
}

TEST(Shorthand, Metals_AreOneAndTheirValuesAreNot) {
    EXPECT_TRUE(isShorthand(metal()));
    EXPECT_FALSE(isShorthand(*conductor().parameter("eta")));
}

TEST(Shorthand, Choice_IsInNoShader) {
    for (const ParameterField& field : layoutOf(conductor()).fields) {
        EXPECT_NE(field.name, "metal");
    }
}

TEST(Shorthand, Choosing_SetsWhatItNames) {
    const Values after =
        afterEdit(conductor(), defaultValues(conductor()), metal(), std::string("silver"));
    EXPECT_EQ(after.at("eta"), roundedToFloat(filledBy("silver", "eta")));
    EXPECT_EQ(after.at("k"), roundedToFloat(filledBy("silver", "k")));
    EXPECT_EQ(after.size(), 3u);
}

TEST(Shorthand, TypingAValue_TurnsItToOnesOwn) {
    const Values after = afterEdit(conductor(), defaultValues(conductor()),
                                   *conductor().parameter("k"), glm::dvec3(1.0));
    EXPECT_EQ(after.at("metal"), Value(std::string("custom")));
    EXPECT_EQ(after.at("k"), Value(glm::dvec3(1.0)));
    EXPECT_FALSE(after.contains("eta"));
}

TEST(Shorthand, AnotherParameter_LeavesItAlone) {
    const Values after = afterEdit(conductor(), defaultValues(conductor()),
                                   *conductor().parameter("index.outside"), 1.5);
    EXPECT_EQ(after.size(), 1u);
}

TEST(Shorthand, ValueGivenBesideIt_Wins) {
    Values given{{"metal", std::string("copper")}, {"k", glm::dvec3(2.0)}};
    fillGaps(conductor(), given);
    EXPECT_EQ(given.at("eta"), filledBy("copper", "eta"));
    EXPECT_EQ(given.at("k"), Value(glm::dvec3(2.0)));
}

TEST(Shorthand, ValuesThatItDoesNotSay_TurnItToOnesOwn) {
    Values values = defaultValues(conductor());
    values["eta"] = glm::dvec3(2.0);
    settleShorthands(conductor(), values);
    EXPECT_EQ(values.at("metal"), Value(std::string("custom")));
}

TEST(Shorthand, RoundedValues_StillAgreeWithIt) {
    Values values = defaultBlockValues(conductor()).parameters;
    settleShorthands(conductor(), values);
    EXPECT_EQ(values.at("metal"), Value(std::string("gold")));
}

/// What a mirror of the metal reflects facing it, from the literature (Cook and Torrance 1982 and
/// the tables of real-time rendering), which other measurements reach to 0.1.
TEST(Metals, EveryOne_ReflectsAboutWhatIsKnown) {
    const std::map<std::string, glm::dvec3> known{
        {"gold", {1.00, 0.78, 0.34}},     {"silver", {0.97, 0.96, 0.92}},
        {"copper", {0.96, 0.64, 0.54}},   {"aluminium", {0.91, 0.92, 0.92}},
        {"iron", {0.56, 0.57, 0.58}},     {"chromium", {0.55, 0.556, 0.554}},
        {"titanium", {0.54, 0.50, 0.45}}, {"brass", {0.89, 0.79, 0.43}}};
    for (const auto& [id, reflected] : known) {
        const auto n = std::get<glm::dvec3>(filledBy(id.c_str(), "eta"));
        const auto k = std::get<glm::dvec3>(filledBy(id.c_str(), "k"));
        for (int i = 0; i < 3; ++i) {
            const double R = ((n[i] - 1.0) * (n[i] - 1.0) + k[i] * k[i]) /
                             ((n[i] + 1.0) * (n[i] + 1.0) + k[i] * k[i]);
            EXPECT_NEAR(R, reflected[i], 0.1) << id << ' ' << i;
        }
    }
}

TEST(Metals, EveryOne_NamesItsSource) {
    for (const EnumValue& value : metal().values) {
        EXPECT_TRUE(value.fills.empty() || value.doc.find("nm") != std::string::npos) << value.id;
    }
}

} // namespace
} // namespace patina::fills_test
