// SPDX-License-Identifier: GPL-3.0-or-later
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <gtest/gtest.h>

#include "scene/scene.h"

namespace patina::scene_test {
namespace {

constexpr double rounding = 1e-12;

Camera camera(double yaw, double pitch) {
    Camera made;
    made.pivot = {1.0, 2.0, 3.0};
    made.yaw = yaw;
    made.pitch = pitch;
    made.distance = 5.0;
    return made;
}

double apart(const glm::dvec3& a, const glm::dvec3& b) { return glm::distance(a, b); }

TEST(Eye, YawZero_LooksAlongMinusZ) {
    EXPECT_LT(apart(eye(camera(0.0, 0.0)), {1.0, 2.0, 8.0}), rounding);
}

TEST(Eye, PitchNinety_IsAboveThePivot) {
    EXPECT_LT(apart(eye(camera(40.0, 90.0)), {1.0, 7.0, 3.0}), rounding);
}

TEST(ViewMatrix, Eye_BecomesTheOrigin) {
    const Camera tilted = camera(30.0, 20.0);
    const glm::dvec3 seen(viewMatrix(tilted) * glm::dvec4(eye(tilted), 1.0));
    EXPECT_LT(glm::length(seen), rounding);
}

TEST(ViewMatrix, Pivot_IsStraightAhead) {
    const Camera tilted = camera(-120.0, -35.0);
    const glm::dvec3 seen(viewMatrix(tilted) * glm::dvec4(tilted.pivot, 1.0));
    EXPECT_LT(apart(seen, {0.0, 0.0, -5.0}), rounding);
}

TEST(WorldMatrix, Rotation_TurnsAboutXBeforeY) {
    Object object;
    object.rotation = {90.0, 90.0, 0.0};
    const glm::dvec3 turned(worldMatrix(object) * glm::dvec4(0.0, 1.0, 0.0, 1.0));
    EXPECT_LT(apart(turned, {1.0, 0.0, 0.0}), rounding);
}

} // namespace
} // namespace patina::scene_test
