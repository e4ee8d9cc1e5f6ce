// SPDX-License-Identifier: GPL-3.0-or-later
// How far a metal's table is from its exact reflectance: in double precision, so that the error is
// that of the means between entries alone.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "physics_cases.h"

namespace patina::physics::metal_table_test {
namespace {

double tableError(double eta, double k, double outside = 1.0) {
    const Values values{{"eta", glm::dvec3(eta)}, {"k", glm::dvec3(k)}, {"index.outside", outside}};
    const Subject exact("fresnel", "conductor", values);
    const Subject tabled("fresnel", "conductor", values, {{"reflectance", "table"}});
    constexpr int steps = 8000;
    double worst = 0.0;
    for (int i = 0; i <= steps; ++i) {
        const double c = static_cast<double>(i) / steps;
        worst = std::max(worst, std::abs(tabled.reflectance(c) - exact.reflectance(c)));
    }
    return worst;
}

TEST(MetalTable, OfMetals_IsClose) {
    EXPECT_LE(tableError(0.156, 3.602), 2e-4);        // gold
    EXPECT_LE(tableError(1.346, 7.475), 2e-4);        // aluminium
    EXPECT_LE(tableError(3.107, 3.331), 2e-4);        // chromium, the furthest off of the list
    EXPECT_LE(tableError(3.107, 3.331, 1.5), 2e-4);   // under lacquer
}

TEST(MetalTable, OfStrongAbsorbersAndOfClearOnes_KeepsItsBounds) {
    EXPECT_LE(tableError(20.0, 20.0), 0.006);
    EXPECT_LE(tableError(0.5, 0.001), 0.1);
    EXPECT_LE(tableError(0.9, 0.0), 0.1);
}

TEST(MetalTable, OfChannels_KeepsThemApart) {
    const Values gold{{"eta", glm::dvec3(0.156, 0.424, 1.383)},
                      {"k", glm::dvec3(3.602, 2.472, 1.915)}};
    const Subject exact("fresnel", "conductor", gold);
    const Subject tabled("fresnel", "conductor", gold, {{"reflectance", "table"}});
    for (int i = 0; i < 3; ++i) {
        const double right = exact.code->fresnel(0.3, 0.7, exact.parameters)[i];
        EXPECT_NEAR(tabled.code->fresnel(0.3, 0.7, tabled.parameters)[i], right, 2e-4) << i;
    }
}

} // namespace
} // namespace patina::physics::metal_table_test
