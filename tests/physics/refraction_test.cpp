// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "physics_cases.h"

namespace patina::physics::refraction_test {
namespace {

glm::dvec3 refractedFrom(const glm::dvec3& l, double eta) {
    const auto t = call("refractedDirection", {l.x, l.y, l.z, 0.0, 0.0, 1.0, eta});
    return {t[0], t[1], t[2]};
}

TEST(RefractedDirection, Upwards_ObeysSnellsLaw) {
    for (const double degrees : {0.0, 1e-4, 30.0, 60.0, 89.9999}) {
        for (const double eta : {0.9999, 1.0, 1.0 + 1e-6, 1.5, 100.0}) {
            const glm::dvec3 l = direction(degrees, 25.0);
            const glm::dvec3 t = refractedFrom(l, eta);
            const double sine = std::hypot(l.x, l.y);
            if (sine < eta) {
                EXPECT_NEAR(std::hypot(t.x, t.y), sine / eta, 1e-14) << degrees << ' ' << eta;
                EXPECT_NEAR(glm::length(t), 1.0, 1e-14) << degrees << ' ' << eta;
                EXPECT_LT(t.z, 0.0);
            }
        }
    }
}

TEST(RefractedDirection, BeyondTheCriticalAngle_IsZero) {
    EXPECT_EQ(refractedFrom(direction(42.0, 0.0), 1.0 / 1.5), glm::dvec3(0.0));
}

TEST(RefractedDirection, BackAgain_IsTheWayItCame) {
    const glm::dvec3 l = direction(50.0, 200.0);
    const glm::dvec3 t = refractedFrom(l, 1.5);
    const glm::dvec3 back = refractedFrom({t.x, t.y, -t.z}, 1.0 / 1.5);
    EXPECT_NEAR(glm::distance(glm::dvec3(back.x, back.y, -back.z), l), 0.0, 1e-14);
}

TEST(RefractCos, MatchedIndices_KeepTheCosine) {
    for (const double c : {0.0, 1e-8, 1e-5, 0.5, 1.0}) {
        EXPECT_NEAR(call("refractCos", {c, 1.0})[0], c, 1e-15);
    }
}

TEST(CriticalAngle, IntoTheDenserSide_IsGrazing) {
    EXPECT_NEAR(call("criticalAngle", {1.5})[0], std::numbers::pi / 2.0, 1e-15);
}

TEST(CauchyIndex, BorosilicateGlass_IsThatOfItsCatalogue) {
    // Schott N-BK7: A 1.5046, B 0.0042 um^2 give n_D = 1.5167.
    const auto n = call("cauchyIndex", {0.6563, 0.5893, 0.4861, 1.5046, 0.0042, 0.0});
    EXPECT_NEAR(n[0], 1.5144, 1e-4);
    EXPECT_NEAR(n[1], 1.5167, 1e-4);
    EXPECT_NEAR(n[2], 1.5224, 1e-4);
}

} // namespace
} // namespace patina::physics::refraction_test
