// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "core/surface_marks.h"
#include "scene/primitives.h"

namespace patina::surface_marks_test {
namespace {

/// Triangles in the plane z = 0, each with its right angle at a place, and as wide as high.
Mesh triangles(const std::vector<std::pair<glm::vec2, float>>& all) {
    Mesh mesh;
    for (const auto& [corner, size] : all) {
        for (const glm::vec2 offset :
             {glm::vec2(0.0f), glm::vec2(size, 0.0f), glm::vec2(0.0f, size)}) {
            mesh.indices.push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
            mesh.vertices.push_back({glm::vec3(corner + offset, 0.0f)});
        }
    }
    mesh.bounds = boundsOf(mesh.vertices);
    return mesh;
}

std::vector<SurfaceMark> marksOn(const Mesh& mesh, std::size_t count, std::size_t atOnce = 1000) {
    SurfaceMarks marks(mesh.view());
    for (int i = 0; i < 200000 && (!marks.isMeasured() || marks.marks().size() < count); ++i) {
        marks.proceed(mesh.view(), atOnce, count);
    }
    return {marks.marks().begin(), marks.marks().end()};
}

TEST(SurfaceMarks, EveryPrefix_IsSpreadEvenly) {
    const Mesh ball = *primitive("sphere");
    const double area = 4.0 * 3.14159;
    const std::vector<SurfaceMark> marks = marksOn(ball, 1024);
    for (const std::size_t count : {32u, 200u, 1024u}) {
        double least = 1e9;
        for (std::size_t i = 0; i < count; ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                least = std::min<double>(least,
                                         glm::distance(marks[i].at.position, marks[j].at.position));
            }
        }
        EXPECT_GT(least, 0.5 * std::sqrt(area / double(count))) << count;
    }
}

TEST(SurfaceMarks, OfTwoTriangles_AreAsManyAsTheirAreas) {
    const std::vector<SurfaceMark> marks =
        marksOn(triangles({{{0.0f, 0.0f}, 1.0f}, {{5.0f, 0.0f}, 3.0f}}), 1000);
    const auto small = std::ranges::count_if(
        marks, [](const SurfaceMark& mark) { return mark.at.position.x < 2.0f; });
    EXPECT_NEAR(double(small), 100.0, 12.0);
}

TEST(SurfaceMarks, InOtherSteps_AreTheSame) {
    const Mesh ball = *primitive("sphere");
    const std::vector<SurfaceMark> fine = marksOn(ball, 300, 7);
    const std::vector<SurfaceMark> coarse = marksOn(ball, 300, 100000);
    ASSERT_EQ(fine.size(), coarse.size());
    for (std::size_t i = 0; i < fine.size(); ++i) {
        EXPECT_EQ(fine[i].at, coarse[i].at) << i;
    }
}

TEST(SurfaceMarks, OfASheetSeenFromBothSides_AreSpreadOnEach) {
    Mesh sheet = triangles({{{0.0f, 0.0f}, 1.0f}, {{0.0f, 0.0f}, 1.0f}});
    for (std::size_t i = 3; i < 6; ++i) {
        sheet.vertices[i].normal.z = -1.0f;
    }
    const std::vector<SurfaceMark> marks = marksOn(sheet, 400);
    const auto above = std::ranges::count_if(
        marks, [](const SurfaceMark& mark) { return mark.at.normal.z > 0.0f; });
    EXPECT_NEAR(double(above), 200.0, 12.0);
}

TEST(SurfaceMarks, OfAMeshWithoutAnArea_AreNone) {
    EXPECT_TRUE(marksOn(triangles({{{1.0f, 1.0f}, 0.0f}}), 0).empty());
    Mesh broken = triangles({{{0.0f, 0.0f}, 1.0f}});
    broken.vertices[1].position.x = std::numeric_limits<float>::quiet_NaN();
    SurfaceMarks marks(broken.view());
    marks.proceed(broken.view(), 100, 10);
    EXPECT_TRUE(marks.isMeasured());
    EXPECT_TRUE(marks.marks().empty());
}

TEST(SurfaceMarks, Needed_CountsMarksOnASquareMetre) {
    const std::vector<SurfaceMark> marks = marksOn(triangles({{{0.0f, 0.0f}, 2.0f}}), 50);
    EXPECT_FLOAT_EQ(marks[9].needed, 5.0f);
    EXPECT_FLOAT_EQ(marks[49].needed, 25.0f);
}

TEST(SurfaceMarks, Bend_IsThatOfABallAndNoneOnAPlane) {
    Mesh ball = *primitive("sphere");
    for (const SurfaceMark& mark : marksOn(ball, 50)) {
        EXPECT_NEAR(mark.bend, 1.0f, 0.01f);
    }
    for (Vertex& vertex : ball.vertices) {
        vertex.normal = -vertex.normal;
    }
    EXPECT_NEAR(marksOn(ball, 50)[7].bend, -1.0f, 0.01f);
    EXPECT_EQ(marksOn(triangles({{{0.0f, 0.0f}, 2.0f}}), 50)[7].bend, 0.0f);
}

/// Normals that were worked out for a tilted plane differ by what floats round.
TEST(SurfaceMarks, Bend_IsNotWhatIsLostToRounding) {
    Mesh plane = triangles({{{0.0f, 0.0f}, 2.0f}});
    plane.vertices[1].normal += glm::vec3(1e-6f, 0.0f, 0.0f);
    EXPECT_EQ(marksOn(plane, 50)[7].bend, 0.0f);
}

} // namespace
} // namespace patina::surface_marks_test
