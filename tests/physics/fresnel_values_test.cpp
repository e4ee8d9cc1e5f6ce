// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "physics_cases.h"

namespace patina::physics {
namespace {

/// The tables have 15 digits.
constexpr double tableRounding = 1e-12;

double cosineOf(const nlohmann::json& row) {
    return row.contains("cos") ? row["cos"].get<double>()
                               : std::cos(row["degrees"].get<double>() * std::numbers::pi / 180.0);
}

/// Near the critical angle the cosine's own 15 digits bound what can be agreed on:
/// dR/dc grows as 1 / g with g^2 = eta^2 - 1 + c^2.
double toleranceAt(double c, double outside, double inside) {
    const double eta = inside / outside;
    const double g2 = eta * eta - 1.0 + c * c;
    return tableRounding + (g2 > 0.0 ? 8e-15 / std::sqrt(g2) : 0.0);
}

void expectTable(const std::string& polarisation, const std::string& column) {
    for (const auto& boundary : table("fresnel.json")["boundaries"]) {
        const double outside = boundary["outside"];
        const double inside = boundary["inside"];
        const Subject fresnel(
            "fresnel", "dielectric",
            {{"index.outside", outside}, {"index.inside", inside}, {"polarisation", polarisation}});
        for (const auto& row : boundary["rows"]) {
            const double c = cosineOf(row);
            EXPECT_NEAR(fresnel.reflectance(c), row[column].get<double>(),
                        toleranceAt(c, outside, inside))
                << boundary["name"] << " at " << row["degrees"] << " degrees";
        }
    }
}

TEST(DielectricFresnel, UnpolarisedLight_MatchesFresnelsEquations) {
    expectTable("unpolarised", "R");
}

TEST(DielectricFresnel, LightPolarisedAcross_MatchesFresnelsEquations) {
    expectTable("s", "Rs");
}

TEST(DielectricFresnel, LightPolarisedAlong_MatchesFresnelsEquations) {
    expectTable("p", "Rp");
}

TEST(DielectricFresnel, NormalIncidence_IsTheSquareOfTheIndexContrast) {
    for (const auto& row : table("fresnel.json")["normalIncidence"]) {
        const double inside = row["inside"];
        EXPECT_NEAR(Subject("fresnel", "dielectric", {{"index.inside", inside}}).reflectance(1.0),
                    row["f0"].get<double>(), tableRounding);
    }
}

TEST(DielectricFresnel, EqualIndices_ReflectNothingAtAnyAngle) {
    const Subject fresnel("fresnel", "dielectric", {{"index.outside", 1.5}, {"index.inside", 1.5}});
    for (const double c : {0.0, 1e-8, 0.3, 1.0}) {
        EXPECT_EQ(fresnel.reflectance(c), 0.0);
    }
}

TEST(DielectricFresnel, NearlyEqualIndices_KeepTheirDigits) {
    // R(0) = ((n - 1) / (n + 1))^2 for n = 1 + 1e-6, a difference that a rounded g would lose.
    const double index = 1.0 + 1e-6;
    const double exact = std::pow((index - 1.0) / (index + 1.0), 2.0);
    EXPECT_NEAR(Subject("fresnel", "dielectric", {{"index.inside", index}}).reflectance(1.0) /
                    exact,
                1.0, 1e-9);
}

TEST(DielectricFresnel, SeenFromBothSides_IsTheSameAlongOneRay) {
    const Subject in("fresnel", "dielectric", {{"index.outside", 1.0}, {"index.inside", 1.5}});
    const Subject out("fresnel", "dielectric", {{"index.outside", 1.5}, {"index.inside", 1.0}});
    for (const double c : {0.05, 0.3, 0.7, 1.0}) {
        const double refracted = std::sqrt(1.0 - (1.0 - c * c) / (1.5 * 1.5));
        EXPECT_NEAR(in.reflectance(c), out.reflectance(refracted), tableRounding);
    }
}

TEST(SchlickFresnel, FourPercent_MatchesItsTable) {
    const Subject fresnel("fresnel", "schlick", {{"f0", glm::dvec3(0.04)}});
    for (const auto& row : table("fresnel.json")["schlick"]["rows"]) {
        EXPECT_NEAR(fresnel.reflectance(row["cos"]), row["F"].get<double>(), tableRounding);
    }
}

TEST(EmpiricalFresnel, ItsSettings_MatchTheirTable) {
    const auto data = table("fresnel.json")["empirical"];
    for (const auto& set : data["sets"]) {
        const Subject fresnel("fresnel", "empirical",
                              {{"bias", set["bias"].get<double>()},
                               {"scale", set["scale"].get<double>()},
                               {"power", set["power"].get<double>()}});
        for (std::size_t i = 0; i < data["degrees"].size(); ++i) {
            const double c = std::cos(data["degrees"][i].get<double>() * std::numbers::pi / 180.0);
            EXPECT_NEAR(fresnel.reflectance(c), set["F"][i].get<double>(), tableRounding);
        }
    }
}

TEST(EmpiricalFresnel, PowerZero_IsOneEverywhereAtScaleOne) {
    const Subject fresnel("fresnel", "empirical", {{"power", 0.0}});
    EXPECT_EQ(fresnel.reflectance(1.0), 1.0);
    EXPECT_EQ(fresnel.reflectance(0.0), 1.0);
}

TEST(StraussTerms, TheirConstants_MatchTheirTable) {
    for (const auto& row : table("fresnel.json")["strauss"]["rows"]) {
        const double x = row["degrees"].get<double>() / 90.0;
        EXPECT_NEAR(call("straussFresnel", {x, 1.0 - x, 1.12})[0], row["F"].get<double>(), 1e-12);
        EXPECT_NEAR(call("straussShadowing", {1.0 - x, 1.01})[0], row["G"].get<double>(), 1e-12);
    }
}

} // namespace
} // namespace patina::physics
