// SPDX-License-Identifier: GPL-3.0-or-later
// Rays that enter and leave transparent bodies, against the laws of Snell and Fresnel.
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "physics_cases.h"

namespace patina::physics::interface_test {
namespace {

const glm::dvec3 up(0.0, 0.0, 1.0);
constexpr double degree = std::numbers::pi / 180.0;

Subject body(double index, double dispersion = 0.0) {
    return {"refraction", "solid-body", {{"index", index}, {"dispersion", dispersion}}};
}

Subject pane(double index) {
    return {"refraction", "thin-pane", {{"index", index}}};
}

glm::dvec3 goesOn(const Subject& subject, const reference::Interface& c) {
    return subject.code->refract(c, subject.parameters);
}

double mirrored(const Subject& subject, const reference::Interface& c) {
    return subject.code->mirrored(c, subject.parameters);
}

/// The mean of both polarisations, from the angles.
double fresnel(double in, double out) {
    const double across = std::sin(in - out) / std::sin(in + out);
    const double along = std::tan(in - out) / std::tan(in + out);
    return 0.5 * (across * across + along * along);
}

TEST(SolidBody, EnteringAndLeaving_ObeySnellsLaw) {
    for (const double degrees : {1e-4, 20.0, 41.0, 75.0, 89.9, 89.99999}) {
        for (const double index : {0.75, 1.0, 1.0001, 1.5, 2.417, 10.0}) {
            for (const bool leaves : {false, true}) {
                const double eta = leaves ? 1.0 / index : index;
                const double sine = std::sin(degrees * degree) / eta;
                const glm::dvec3 way =
                    goesOn(body(index), {direction(degrees, 0.0), up, 1, leaves});
                if (sine < 1.0) {
                    const glm::dvec3 exact(-sine, 0.0, -std::sqrt(1.0 - sine * sine));
                    EXPECT_LT(glm::distance(way, exact), 1e-7) << degrees << ' ' << index;
                } else {
                    EXPECT_EQ(way, glm::dvec3(0.0)) << degrees << ' ' << index;
                }
            }
        }
    }
}

TEST(SolidBody, GlassFromWithin_ReflectsAllFromTheCriticalAngleOn) {
    const double critical = std::asin(1.0 / 1.5) / degree;
    const Subject glass = body(1.5);
    EXPECT_LT(mirrored(glass, {direction(critical - 1e-3, 0.0), up, 1, true}), 1.0);
    EXPECT_EQ(mirrored(glass, {direction(critical + 1e-9, 0.0), up, 1, true}), 1.0);
    EXPECT_EQ(goesOn(glass, {direction(critical + 1e-9, 0.0), up, 1, true}), glm::dvec3(0.0));
}

TEST(SolidBody, IndexOne_LeavesTheRayAlone) {
    for (const double degrees : {0.0, 45.0, 89.9999}) {
        const glm::dvec3 l = direction(degrees, 30.0);
        EXPECT_LT(glm::distance(goesOn(body(1.0, 2.0), {l, up, 0, false}), -l), 1e-15);
        EXPECT_EQ(mirrored(body(1.0), {l, up, 1, true}), 0.0);
    }
}

TEST(SolidBody, Reflectance_IsFresnels) {
    for (const double degrees : {5.0, 30.0, 60.0, 85.0}) {
        const double in = degrees * degree;
        EXPECT_NEAR(mirrored(body(1.5), {direction(degrees, 0.0), up, 1, false}),
                    fresnel(in, std::asin(std::sin(in) / 1.5)), 1e-14);
    }
}

TEST(SolidBody, ThereAndBack_LosesTheSame) {
    const reference::Interface in{direction(50.0, 0.0), up, 1, false};
    const glm::dvec3 inside = goesOn(body(1.5), in);
    const reference::Interface out{glm::dvec3(inside.x, 0.0, -inside.z), up, 1, true};
    EXPECT_NEAR(mirrored(body(1.5), out), mirrored(body(1.5), in), 1e-14);
}

// Sellmeier's equation with the maker's coefficients of N-BK7 (n_d 1.516798, Abbe number 64.17)
// gives 1.514520, 1.518522 and 1.525320 at 650, 550 and 450 nm.
TEST(SolidBody, CrownGlass_HasTheIndicesOfItsCatalogue) {
    const std::vector<double> n = call("dispersedIndices", {1.516798, 20.0 / 64.17});
    EXPECT_NEAR(n[0], 1.514520, 2e-4);
    EXPECT_NEAR(n[1], 1.518522, 2e-4);
    EXPECT_NEAR(n[2], 1.525320, 2e-4);
}

TEST(SolidBody, Dispersion_BendsBlueMost) {
    const auto sine = [](int channel) {
        return std::abs(goesOn(body(1.5, 0.5), {direction(60.0, 0.0), up, channel, false}).x);
    };
    EXPECT_LT(sine(2), sine(1));
    EXPECT_LT(sine(1), sine(0));
}

TEST(SolidBody, TwiceAsFarInside_IsLeftTwice) {
    const Subject amber("refraction", "solid-body",
                        {{"absorption.color", glm::dvec3(0.8, 0.4, 0.1)},
                         {"absorption.distance", 0.05},
                         {"tint", glm::dvec3(0.5, 1.0, 1.0)}});
    const glm::dvec3 left = amber.code->left(0.1, amber.parameters);
    EXPECT_LT(glm::distance(left, glm::dvec3(0.32, 0.16, 0.01)), 1e-14);
}

TEST(SolidBody, BlackInside_LetsThinPartsThrough) {
    const Subject tar("refraction", "solid-body", {{"absorption.color", glm::dvec3(0.0)}});
    EXPECT_EQ(tar.code->left(0.0, tar.parameters), glm::dvec3(1.0));
    EXPECT_LT(tar.code->left(1.0, tar.parameters).x, 1e-29);
}

// A window lets (1 - R) / (1 + R) = 0.923077 pass.
TEST(ThinPane, Glass_ReflectsWithBothFaces) {
    EXPECT_NEAR(mirrored(pane(1.5), {up, up, 1, false}), 1.0 - 0.92307692307692, 1e-13);
}

TEST(ThinPane, Leaving_GoesOnAsItCame) {
    for (const double degrees : {0.0, 45.0, 89.99}) {
        const glm::dvec3 l = direction(degrees, 70.0);
        const glm::dvec3 inside = goesOn(pane(1.5), {l, up, 1, false});
        const glm::dvec3 out = goesOn(pane(1.5), {-inside, up, 1, true});
        EXPECT_LT(glm::distance(out, -l), 1e-12) << degrees;
    }
}

} // namespace
} // namespace patina::physics::interface_test
