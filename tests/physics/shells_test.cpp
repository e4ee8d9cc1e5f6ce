// SPDX-License-Identifier: GPL-3.0-or-later
// The form and the light of strands.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "physics_cases.h"

namespace patina::physics::shells_test {
namespace {

const glm::dvec3 side = glm::normalize(glm::dvec3(1.0, 0.4, 0.2));

std::array<double, 8> strandAt(double height, const glm::dvec3& n, double nl = 1.0,
                               double size = 0.0) {
    return {height, n.x, n.y, n.z, nl, size, 0.0, 0.3};
}

glm::dvec3 offsetAt(const Subject& fur, double height, const glm::dvec3& n = side) {
    const auto at = fur.code->call<3>("Offset", strandAt(height, n), fur.parameters);
    return {at[0], at[1], at[2]};
}

double radiusAt(const Subject& fur, double height, double size) {
    return fur.code->call<1>("Radius", strandAt(height, side, 1.0, size), fur.parameters)[0];
}

glm::dvec3 tintAt(const Subject& fur, double height, double nl = 1.0) {
    const auto tint = fur.code->call<3>("Tint", strandAt(height, side, nl), fur.parameters);
    return {tint[0], tint[1], tint[2]};
}

TEST(Fur, CombedStrand_KeepsItsLength) {
    for (const double comb : {0.0, 1e-5, 0.3, 1.0}) {
        const Subject fur("shells", "fur", {{"strand.length", 0.5}, {"comb", comb}});
        double length = 0.0;
        constexpr int steps = 4000;
        for (int i = 0; i < steps; ++i) {
            length += glm::distance(offsetAt(fur, double(i) / steps),
                                    offsetAt(fur, double(i + 1) / steps));
        }
        EXPECT_NEAR(length, 0.5, 1e-6) << comb;
    }
}

TEST(Fur, Strand_LeavesTheSkinUpright) {
    const Subject fur("shells", "fur", {{"comb", 1.0}});
    const glm::dvec3 first = glm::normalize(offsetAt(fur, 1e-5));
    EXPECT_NEAR(glm::dot(first, side), 1.0, 1e-9);
    EXPECT_EQ(offsetAt(fur, 0.0), glm::dvec3(0.0));
}

TEST(Fur, StrandCombedAllTheWay_EndsAlongTheSurface) {
    const Subject fur(
        "shells", "fur",
        {{"comb", 1.0}, {"strand.length", 1.0}, {"comb.direction", glm::dvec3(0.0, -1.0, 0.0)}});
    const glm::dvec3 up(0.0, 0.0, 1.0);
    const glm::dvec3 last = glm::normalize(offsetAt(fur, 1.0, up) - offsetAt(fur, 1.0 - 1e-6, up));
    EXPECT_NEAR(last.y, -1.0, 1e-6);
    EXPECT_NEAR(offsetAt(fur, 1.0, up).z, 2.0 / std::numbers::pi, 1e-12); // of a quarter circle
}

TEST(Fur, StrandThatPointsWhereItIsCombed_StaysStraight) {
    const Subject fur(
        "shells", "fur",
        {{"comb", 1.0}, {"strand.length", 1.0}, {"comb.direction", glm::dvec3(0.0, 0.0, 1.0)}});
    const glm::dvec3 up(0.0, 0.0, 1.0);
    EXPECT_NEAR(glm::distance(offsetAt(fur, 0.7, up), 0.7 * up), 0.0, 1e-12);
}

TEST(Fur, UnevenLengths_EndWhereTheirNumberSays) {
    const Subject fur("shells", "fur", {{"variation", 0.6}});
    EXPECT_GT(radiusAt(fur, 0.39, 1.0), 0.0);
    EXPECT_EQ(radiusAt(fur, 0.41, 1.0), 0.0);
    EXPECT_GT(radiusAt(fur, 0.99, 0.0), 0.0);
    EXPECT_EQ(radiusAt(fur, 1.0, 0.0), 0.0);
}

TEST(Fur, Thickness_IsTheWidthAtTheRoot) {
    const Subject fur("shells", "fur", {{"thickness", 0.6}});
    EXPECT_NEAR(radiusAt(fur, 0.0, 0.5), 0.3, 1e-15);
}

TEST(Fur, Shadow_DarkensByBouguersLaw) {
    const Subject fur("shells", "fur",
                      {{"shadow", 1.5},
                       {"root.color", glm::dvec3(1.0)},
                       {"tip.color", glm::dvec3(1.0)},
                       {"tone.variation", 0.0}});
    EXPECT_NEAR(tintAt(fur, 0.0).x, std::exp(-1.5), 1e-15);
    EXPECT_NEAR(tintAt(fur, 0.5, 0.5).x, std::exp(-1.5), 1e-15);
    EXPECT_EQ(tintAt(fur, 1.0, 0.0), glm::dvec3(1.0));
}

/// Light along the strand leaves it dark, light from any side is the same.
TEST(Fur, LightOnAStrand_GoesBySineOfItsAngle) {
    const Subject fur("shells", "fur",
                      {{"strand.color", glm::dvec3(0.5)}, {"strand.highlight", glm::dvec3(0.0)}});
    const glm::dvec3 t(1.0, 0.0, 0.0);
    for (const double angle : {0.2, 0.9, 1.5}) {
        const glm::dvec3 l(std::cos(angle), 0.0, std::sin(angle));
        const auto at = reference::geometry({0.0, 0.0, 1.0}, t, l, {0.0, 0.6, 0.8});
        EXPECT_NEAR(fur.code->model(at, fur.parameters, {}).x, 0.5 * std::sin(angle), 1e-12);
    }
}

/// Kajiya and Kay 1989: a cylinder mirrors light onto a cone about its own direction.
TEST(Fur, Highlight_LiesOnTheConeOfMirrorDirections) {
    const Subject fur("shells", "fur",
                      {{"strand.color", glm::dvec3(0.0)},
                       {"strand.highlight", glm::dvec3(0.75)},
                       {"strand.shininess", 60.0}});
    const glm::dvec3 l = glm::normalize(glm::dvec3(0.6, 0.0, 0.8));
    const double around = std::sqrt(1.0 - l.x * l.x);
    for (const double turn : {-1.0, 0.0, 1.2}) {
        const glm::dvec3 v(-l.x, around * std::sin(turn), around * std::cos(turn));
        const auto at = reference::geometry({0.0, 0.0, 1.0}, {1.0, 0.0, 0.0}, l, v);
        EXPECT_NEAR(fur.code->model(at, fur.parameters, {}).x, 0.75, 1e-12) << turn;
    }
    const auto off = reference::geometry({0.0, 0.0, 1.0}, {1.0, 0.0, 0.0}, l, l);
    EXPECT_LT(fur.code->model(off, fur.parameters, {}).x, 0.01);
}

} // namespace
} // namespace patina::physics::shells_test
