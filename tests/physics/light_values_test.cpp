// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include <glm/geometric.hpp>

#include "physics_cases.h"

namespace patina::physics::light_values_test {
namespace {

reference::Illumination lightAt(const std::string& id, const glm::dvec3& x, const Values& values) {
    const Subject light("lights", id, values);
    return light.code->light(x, light.parameters);
}

double fogAt(const std::string& id, double distance, const Values& values) {
    const Subject fog("fog", id, values);
    return fog.code->fog({{}, {0.0, 0.0, -1.0}, distance}, fog.parameters);
}

TEST(DirectionalLight, ItsDirection_IsTheWayTheLightTravels) {
    const auto light = lightAt("directional", {5, 5, 5}, {{"direction", glm::dvec3(0, -2, 0)}});
    EXPECT_EQ(light.l, glm::dvec3(0, 1, 0));
}

TEST(DirectionalLight, NoDirection_ShinesDown) {
    EXPECT_EQ(lightAt("directional", {0, 0, 0}, {{"direction", glm::dvec3(0)}}).l,
              glm::dvec3(0, 1, 0));
}

TEST(DirectionalLight, Radiance_IsColourTimesIntensity) {
    const auto light =
        lightAt("directional", {0, 0, 0}, {{"color", glm::dvec3(0.5, 1, 0)}, {"intensity", 3.0}});
    EXPECT_EQ(light.radiance, glm::dvec3(1.5, 3, 0));
}

TEST(PointLight, PolynomialFalloff_DividesByItsPolynomial) {
    const Values values{{"position", glm::dvec3(0, 2, 0)},
                        {"attenuation.constant", 1.0},
                        {"attenuation.linear", 0.5},
                        {"attenuation.quadratic", 0.25}};
    EXPECT_DOUBLE_EQ(lightAt("point", {0, 0, 0}, values).radiance.x, 1.0 / 3.0);
}

TEST(PointLight, AllAttenuationZero_IsBoundedByTenThousand) {
    const Values values{{"attenuation.constant", 0.0}};
    EXPECT_DOUBLE_EQ(lightAt("point", {0, 0, 0}, values).radiance.x, 1e4);
}

TEST(PointLight, InverseSquare_IsAQuarterAtTwiceTheDistance) {
    const Values values{{"position", glm::dvec3(0)}, {"falloff", std::string("inverse-square")}};
    EXPECT_DOUBLE_EQ(lightAt("point", {1, 0, 0}, values).radiance.x, 1.0);
    EXPECT_DOUBLE_EQ(lightAt("point", {2, 0, 0}, values).radiance.x, 0.25);
}

TEST(PointLight, WithinItsRadius_GetsNoBrighter) {
    const Values values{{"position", glm::dvec3(0)},
                        {"falloff", std::string("inverse-square")},
                        {"distance.minimum", 0.5}};
    EXPECT_DOUBLE_EQ(lightAt("point", {0.1, 0, 0}, values).radiance.x, 4.0);
    EXPECT_DOUBLE_EQ(lightAt("point", {0, 0, 0}, values).radiance.x, 4.0);
}

TEST(PointLight, AtTheLight_StillHasADirection) {
    const auto light = lightAt("point", {1, 1, 1}, {{"position", glm::dvec3(1)}});
    EXPECT_DOUBLE_EQ(glm::length(light.l), 1.0);
}

/// A spot at (0, 1, 0) that shines straight down on the plane y = 0, seen at `degrees` off its
/// axis.
double spotAt(double degrees, double inner, double outer, double exponent) {
    const double x = std::tan(degrees * std::numbers::pi / 180.0);
    return lightAt("spot", {x, 0, 0},
                   {{"position", glm::dvec3(0, 1, 0)},
                    {"direction", glm::dvec3(0, -1, 0)},
                    {"angle.inner", inner},
                    {"angle.outer", outer},
                    {"falloff.exponent", exponent}})
        .radiance.x;
}

TEST(SpotLight, InsideTheInnerAngle_IsFull) {
    EXPECT_EQ(spotAt(9.9, 10, 30, 1), 1.0);
}

TEST(SpotLight, OutsideTheOuterAngle_IsDark) {
    EXPECT_EQ(spotAt(30.1, 10, 30, 1), 0.0);
}

TEST(SpotLight, BetweenItsAngles_FallsInProportionToTheCosine) {
    const auto cosine = [](double degrees) { return std::cos(degrees * std::numbers::pi / 180.0); };
    const double share = (cosine(20) - cosine(30)) / (cosine(10) - cosine(30));
    EXPECT_NEAR(spotAt(20, 10, 30, 1), share, 1e-12);
    EXPECT_NEAR(spotAt(20, 10, 30, 3), share * share * share, 1e-12);
}

TEST(SpotLight, EqualAngles_AreAStep) {
    EXPECT_EQ(spotAt(24.9, 25, 25, 1), 1.0);
    EXPECT_EQ(spotAt(25.1, 25, 25, 1), 0.0);
}

TEST(SpotLight, InnerBeyondOuter_CountsAsOuter) {
    EXPECT_EQ(spotAt(24.9, 60, 25, 1), 1.0);
    EXPECT_EQ(spotAt(25.1, 60, 25, 1), 0.0);
}

TEST(SpotLight, ExponentZero_IsFullUpToTheEdge) {
    EXPECT_EQ(spotAt(29.9, 10, 30, 0), 1.0);
}

TEST(SpotLight, TenthOfADegree_IsStillACone) {
    EXPECT_EQ(spotAt(0.09, 0.1, 0.1, 1), 1.0);
    EXPECT_EQ(spotAt(0.11, 0.1, 0.1, 1), 0.0);
}

/// The cone ends at 0.02 degrees, whose versine is 6e-8: what is cut at the narrowest outer cone of
/// 1e-13 would show.
TEST(SpotLight, InnerAngleOfZero_IsNotWidened) {
    const auto versine = [](double degrees) {
        const double half = std::sin(0.5 * degrees * std::numbers::pi / 180.0);
        return 2.0 * half * half;
    };
    EXPECT_NEAR(spotAt(0.01, 0, 0.02, 1), 1.0 - versine(0.01) / versine(0.02), 1e-9);
    EXPECT_EQ(spotAt(0.0, 0, 0.02, 1), 1.0);
    EXPECT_EQ(spotAt(0.01, 0, 0, 1), 0.0);
}

TEST(HeadLight, ItsOffset_IsWhereItShinesFrom) {
    const auto light = lightAt("head", {0, 0, 0}, {{"offset", glm::dvec3(0, 0, 4)}});
    EXPECT_EQ(light.l, glm::dvec3(0, 0, 1));
    EXPECT_EQ(light.radiance, glm::dvec3(1));
}

TEST(LinearFog, HalfWay_LeavesHalf) {
    EXPECT_DOUBLE_EQ(fogAt("linear", 6.0, {{"start", 2.0}, {"end", 10.0}}), 0.5);
}

TEST(LinearFog, StartAtItsEnd_IsAWall) {
    const Values wall{{"start", 3.0}, {"end", 3.0}};
    EXPECT_EQ(fogAt("linear", 2.999, wall), 1.0);
    EXPECT_EQ(fogAt("linear", 3.0, wall), 0.0);
}

TEST(ExponentialFog, OneOverItsDensityAway_LeavesOneOverE) {
    EXPECT_DOUBLE_EQ(fogAt("exponential", 4.0, {{"density", 0.25}}), std::exp(-1.0));
    EXPECT_DOUBLE_EQ(fogAt("exponential-squared", 8.0, {{"density", 0.25}}), std::exp(-4.0));
}

TEST(ExponentialFog, NoOrHugeDensity_IsNothingOrEverything) {
    for (const char* id : {"exponential", "exponential-squared"}) {
        EXPECT_EQ(fogAt(id, 1e6, {{"density", 0.0}}), 1.0);
        EXPECT_EQ(fogAt(id, 1e6, {{"density", 1000.0}}), 0.0);
        EXPECT_EQ(fogAt(id, 0.0, {{"density", 1000.0}}), 1.0);
    }
}

/// What fog whose density is given at each point leaves, summed up in small steps along the ray.
double leftByStepping(const reference::FogRay& ray,
                      const std::function<double(const glm::dvec3&)>& density) {
    constexpr int steps = 200000;
    double sum = 0.0;
    for (int i = 0; i < steps; ++i) {
        sum += density(ray.eye + (i + 0.5) / steps * ray.range * ray.direction);
    }
    return std::exp(-sum * ray.range / steps);
}

const reference::FogRay crossingRays[] = {
    {{0.0, 3.0, 0.0}, glm::normalize(glm::dvec3(0.2, -0.9, 0.1)), 5.0},  // from above into it
    {{0.5, -2.0, 1.0}, glm::normalize(glm::dvec3(0.3, 0.8, -0.4)), 6.0}, // out of it
    {{0.0, 0.7, 0.0}, {1.0, 0.0, 0.0}, 2.0},                             // level
    {{-3.0, 0.1, 0.2}, glm::normalize(glm::dvec3(1.0, 1e-9, 0.01)), 7.0},
    {{0.0, 0.4, 0.0}, glm::normalize(glm::dvec3(-0.5, 0.6, 0.7)), 0.3},
    {{0.1, 5.0, -0.1}, {0.0, -1.0, 0.0}, 9.0},
};

TEST(LowLyingFog, OnEveryRay_LeavesWhatItsDensityAddsUpTo) {
    const Subject fog("fog", "height", {{"density", 0.8}, {"base", 0.2}, {"thickness", 0.6}});
    for (const reference::FogRay& ray : crossingRays) {
        const double stepped = leftByStepping(ray, [](const glm::dvec3& x) {
            return 0.8 * std::exp(-std::max(x.y - 0.2, 0.0) / 0.6);
        });
        EXPECT_NEAR(fog.code->fog(ray, fog.parameters), stepped, 1e-6 * stepped) << ray.eye.y;
    }
}

TEST(LowLyingFog, WithoutThickness_EndsAtItsBase) {
    const Subject fog("fog", "height", {{"density", 1.0}, {"base", 0.0}, {"thickness", 0.0}});
    EXPECT_NEAR(fog.code->fog({{0, 2, 0}, {0, -1, 0}, 3.0}, fog.parameters), std::exp(-1.0), 1e-6);
    EXPECT_EQ(fog.code->fog({{0, 2, 0}, {1, 0, 0}, 3.0}, fog.parameters), 1.0);
}

TEST(BoxedFog, OnEveryRay_LeavesWhatItsDensityAddsUpTo) {
    const glm::dvec3 center(0.1, 0.5, -0.2);
    const glm::dvec3 size(2.0, 1.0, 3.0);
    const Subject fog("fog", "box", {{"density", 0.8}, {"center", center}, {"size", size}});
    for (const reference::FogRay& ray : crossingRays) {
        const double stepped = leftByStepping(ray, [&](const glm::dvec3& x) {
            const glm::dvec3 off = glm::abs(x - center) - 0.5 * size;
            return std::max({off.x, off.y, off.z}) < 0.0 ? 0.8 : 0.0;
        });
        EXPECT_NEAR(fog.code->fog(ray, fog.parameters), stepped, 1e-4 * stepped) << ray.eye.y;
    }
}

TEST(BoxedFog, ThinAndFarAway_KeepsItsDigits) {
    const Subject fog("fog", "box",
                      {{"density", 1000.0},
                       {"center", glm::dvec3(0.0, 0.0, -1e6)},
                       {"size", glm::dvec3(10.0, 10.0, 1e-3)}});
    EXPECT_NEAR(fog.code->fog({{}, {0, 0, -1}, 2e6}, fog.parameters), std::exp(-1.0), 1e-7);
}

} // namespace
} // namespace patina::physics::light_values_test
