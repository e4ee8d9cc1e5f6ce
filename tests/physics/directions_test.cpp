// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "physics_cases.h"

namespace patina::physics::directions_test {
namespace {

enum Projection {
    nl,
    nv,
    nh,
    lh,
    lv,
    rv,
    lt,
    lb,
    vt,
    vb,
    ht,
    hb,
    sin2h,
    cos2h,
    HH,
    nH,
    versineLh,
    versineRv
};

std::vector<double> projections(const glm::dvec3& l, const glm::dvec3& v) {
    return call("directions", {0, 0, 1, 1, 0, 0, 0, 1, 0, l.x, l.y, l.z, v.x, v.y, v.z});
}

glm::dvec3 tangentAlong(const glm::dvec3& n, const glm::dvec3& t) {
    const auto r = call("tangentAlong", {n.x, n.y, n.z, t.x, t.y, t.z});
    return {r[0], r[1], r[2]};
}

void expectTangentOf(const glm::dvec3& n, const glm::dvec3& t) {
    EXPECT_NEAR(glm::dot(n, t), 0.0, 1e-15);
    EXPECT_NEAR(glm::length(t), 1.0, 1e-15);
}

TEST(Directions, OppositeVectors_PutTheHalfVectorIntoTheSurface) {
    const glm::dvec3 l = direction(40, 30);
    const auto d = projections(l, -l);
    EXPECT_EQ(d[nh], 0.0);
    EXPECT_EQ(d[lh], 0.0);
    EXPECT_EQ(d[sin2h], 1.0);
    EXPECT_EQ(d[cos2h], 0.0);
    EXPECT_NEAR(d[versineLh], 1.0, 1e-15);
}

TEST(Directions, EqualVectors_HaveNoHalfAngle) {
    const glm::dvec3 l = direction(40, 30);
    const auto d = projections(l, l);
    EXPECT_EQ(d[versineLh], 0.0);
    EXPECT_NEAR(d[lh], 1.0, 1e-15);
    EXPECT_NEAR(d[nh], l.z, 1e-15);
}

TEST(Directions, MirroredVectors_HaveNoMirrorAngle) {
    const auto d = projections(direction(50, 30), direction(50, 210));
    EXPECT_NEAR(d[versineRv], 0.0, 1e-30);
    EXPECT_NEAR(d[sin2h] / d[cos2h], 0.0, 1e-30);
}

TEST(Directions, SmallMirrorOffset_KeepsItsDigits) {
    // r and v are 1e-6 rad apart: 1 - cos = 2 sin^2(5e-7), which 1 - r.v would round to 4 digits.
    const double offset = 1e-6;
    const auto d = projections(direction(0, 0), {std::sin(offset), 0.0, std::cos(offset)});
    EXPECT_NEAR(d[versineRv] / (2.0 * std::pow(std::sin(0.5 * offset), 2.0)), 1.0, 1e-9);
}

TEST(Directions, HalfVector_HasItsComponents) {
    const glm::dvec3 l = direction(70, 10);
    const glm::dvec3 v = direction(20, 100);
    const glm::dvec3 h = glm::normalize(l + v);
    const auto d = projections(l, v);
    EXPECT_NEAR(d[ht], h.x, 1e-15);
    EXPECT_NEAR(d[hb], h.y, 1e-15);
    EXPECT_NEAR(d[nh], h.z, 1e-15);
    EXPECT_NEAR(d[sin2h] / (d[sin2h] + d[cos2h]), h.x * h.x + h.y * h.y, 1e-15);
}

TEST(Directions, BelowTheHorizon_HasNegativeCosines) {
    const auto d = projections(direction(120, 0), direction(100, 50));
    EXPECT_NEAR(d[nl], -0.5, 1e-15);
    EXPECT_LT(d[nv], 0.0);
}

TEST(TangentAlong, AnyDirection_IsMadePerpendicular) {
    const glm::dvec3 n = direction(33, 77);
    const glm::dvec3 t = tangentAlong(n, {0.3, -0.2, 0.9});
    expectTangentOf(n, t);
    EXPECT_GT(glm::dot(t, {0.3, -0.2, 0.9}), 0.0);
}

TEST(TangentAlong, ParallelOrZero_BecomesSomeTangent) {
    for (const glm::dvec3& n : {direction(0, 0), direction(180, 0), direction(90, 0),
                                direction(179.9999, 45), direction(33, 77)}) {
        expectTangentOf(n, tangentAlong(n, n));
        expectTangentOf(n, tangentAlong(n, -3.0 * n));
        expectTangentOf(n, tangentAlong(n, {0, 0, 0}));
    }
}

TEST(TangentAlong, ItsLength_DoesNotMatter) {
    const glm::dvec3 n = direction(20, 10);
    const glm::dvec3 t = tangentAlong(n, {1, 2, 3});
    for (const double scale : {1e-25, 1e25}) {
        EXPECT_NEAR(glm::length(tangentAlong(n, scale * glm::dvec3(1, 2, 3)) - t), 0.0, 1e-14);
    }
}

TEST(SafeNormalize, Zero_IsTheFallback) {
    EXPECT_EQ(call("safeNormalize", {0, 0, 0, 0, 1, 0}), (std::vector<double>{0, 1, 0}));
}

TEST(SlopeWidth, Roughness_IsTheWidthDownToItsFloor) {
    EXPECT_EQ(call("slopeWidth", {0.3})[0], 0.3);
    EXPECT_EQ(call("slopeWidth", {0.0})[0], 1e-4);
}

} // namespace
} // namespace patina::physics::directions_test
