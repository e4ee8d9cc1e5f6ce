// SPDX-License-Identifier: GPL-3.0-or-later
// Cut stones, by the numbers of their cuts. Frames, windings and places of images are tested with
// all other primitives.
#include "scene/gem_cuts.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/convex_facets.h"

namespace patina::gem_cuts_test {
namespace {

/// Degrees between a facet and the table, from 0 (the table) over 90 (the girdle) to 180.
double slope(const FacetPlane& facet) {
    return std::acos(std::clamp(facet.normal.y, -1.0, 1.0)) * 180.0 / std::numbers::pi;
}

long countOf(const ConvexFacets& facets, double degrees) {
    return std::ranges::count_if(facets.planes, [degrees](const FacetPlane& facet) {
        return std::abs(slope(facet) - degrees) < 0.01;
    });
}

long countBetween(const ConvexFacets& facets, double from, double to) {
    return std::ranges::count_if(facets.planes, [from, to](const FacetPlane& facet) {
        return slope(facet) > from && slope(facet) < to;
    });
}

class Brilliant : public testing::Test {
  protected:
    const Mesh mesh_ = roundBrilliant();
    const ConvexFacets facets_ = convexFacetsOf(mesh_.view());
};

TEST_F(Brilliant, HasThirtyThreeFacetsAboveTheGirdleAndTwentyFourBelow) {
    EXPECT_EQ(facets_.whyNot, "");
    EXPECT_EQ(countBetween(facets_, -1.0, 89.0), 33);
    EXPECT_EQ(countOf(facets_, 90.0), 32);
    EXPECT_EQ(countBetween(facets_, 91.0, 180.0), 24);
}

TEST_F(Brilliant, HasTolkowskysAngles) {
    EXPECT_EQ(countOf(facets_, 0.0), 1);
    EXPECT_EQ(countOf(facets_, 34.5), 8);
    EXPECT_EQ(countOf(facets_, 180.0 - 40.75), 8);
}

TEST_F(Brilliant, HasStarsFlatterAndHalvesSteeperThanItsMains) {
    EXPECT_EQ(countBetween(facets_, 15.0, 30.0), 8);
    EXPECT_EQ(countBetween(facets_, 36.0, 45.0), 16);
    EXPECT_EQ(countBetween(facets_, 180.0 - 45.0, 180.0 - 41.0), 16);
}

/// The table's corners are 0.53 from the axis, and the girdle's 1.
TEST_F(Brilliant, HasTheTablesWidthAndAThinGirdle) {
    float table = 0.0f;
    float top = -1.0f;
    float bottom = 1.0f;
    for (const Vertex& vertex : mesh_.vertices) {
        const float across = std::hypot(vertex.position.x, vertex.position.z);
        EXPECT_LE(across, 1.0f + 1e-5f);
        if (vertex.normal.y > 0.999f) {
            table = std::max(table, across);
        }
        if (std::abs(vertex.normal.y) < 1e-3f) {
            top = std::max(top, vertex.position.y);
            bottom = std::min(bottom, vertex.position.y);
        }
    }
    EXPECT_NEAR(table, 0.53f, 1e-5f);
    EXPECT_GT(top - bottom, 0.02f);
    EXPECT_LT(top - bottom, 0.08f);
}

TEST(EmeraldCut, HasThreeStepsAlongEachOfEightSides) {
    const Mesh mesh = emeraldCut();
    const ConvexFacets facets = convexFacetsOf(mesh.view());
    EXPECT_EQ(facets.whyNot, "");
    EXPECT_EQ(countOf(facets, 0.0), 1);
    EXPECT_EQ(countOf(facets, 90.0), 8);
    for (const double crown : {46.0, 38.0, 30.0}) {
        EXPECT_EQ(countOf(facets, crown), 8) << crown;
    }
    for (const double pavilion : {52.0, 43.0, 34.0}) {
        EXPECT_EQ(countOf(facets, 180.0 - pavilion), 8) << pavilion;
    }
}

} // namespace
} // namespace patina::gem_cuts_test
