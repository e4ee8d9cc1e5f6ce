// SPDX-License-Identifier: GPL-3.0-or-later
// Polygons become triangles that cover each of them: all of it, and nothing beside it.
#include <cmath>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "mesh_files.h"

namespace patina::tests::polygon_test {
namespace {

struct Flat {
    const char* name;
    std::vector<glm::dvec2> outline; ///< to the left
};

double cross(const glm::dvec2& a, const glm::dvec2& b) {
    return a.x * b.y - a.y * b.x;
}

double areaOf(const std::vector<glm::dvec2>& outline) {
    double twice = 0.0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        twice += cross(outline[i], outline[(i + 1) % outline.size()]);
    }
    return 0.5 * twice;
}

/// A whole number of turns around the place: 1 inside of a simple outline, 0 outside.
int turnsAround(const std::vector<glm::dvec2>& outline, const glm::dvec2& place) {
    double angle = 0.0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const glm::dvec2 a = outline[i] - place;
        const glm::dvec2 b = outline[(i + 1) % outline.size()] - place;
        angle += std::atan2(cross(a, b), glm::dot(a, b));
    }
    return static_cast<int>(std::lround(angle / 6.283185307179586));
}

/// One face, tilted so that its plane is none of the axes'.
std::string objOf(const std::vector<glm::dvec2>& outline) {
    std::string points;
    std::string face = "f";
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const glm::dvec2& p = outline[i];
        points += "v " + std::to_string(p.x) + ' ' + std::to_string(p.y) + ' ' +
                  std::to_string(0.5 * p.x - 0.25 * p.y) + '\n';
        face += ' ' + std::to_string(i + 1);
    }
    return points + face + '\n';
}

/// The triangles, seen along z.
std::vector<std::vector<glm::dvec2>> trianglesOf(const MeshView& mesh) {
    std::vector<std::vector<glm::dvec2>> triangles;
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        if (i % 3 == 0) {
            triangles.emplace_back();
        }
        const glm::vec3 position = mesh.vertices[mesh.indices[i]].position;
        triangles.back().emplace_back(position.x, position.y);
    }
    return triangles;
}

class PolygonFile : public testing::TestWithParam<Flat> {};

TEST_P(PolygonFile, Triangles_CoverItOnceAndNothingElse) {
    const auto mesh = loaded("polygon.obj", objOf(GetParam().outline));
    ASSERT_TRUE(mesh) << mesh.error().text();
    double area = 0.0;
    for (const std::vector<glm::dvec2>& triangle : trianglesOf((*mesh)->view())) {
        area += areaOf(triangle);
        const glm::dvec2 middle = (triangle[0] + triangle[1] + triangle[2]) / 3.0;
        EXPECT_EQ(turnsAround(GetParam().outline, middle), 1) << middle.x << ' ' << middle.y;
    }
    EXPECT_NEAR(area, areaOf(GetParam().outline), 1e-6);
}

TEST_P(PolygonFile, NoTriangle_IsThin) {
    const auto mesh = loaded("polygon.obj", objOf(GetParam().outline));
    ASSERT_TRUE(mesh) << mesh.error().text();
    EXPECT_EQ((*mesh)->remarks(), "");
    EXPECT_EQ((*mesh)->view().indices.size(), 3 * (GetParam().outline.size() - 2));
    for (const std::vector<glm::dvec2>& triangle : trianglesOf((*mesh)->view())) {
        EXPECT_GT(areaOf(triangle), 1e-3);
    }
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, PolygonFile,
    testing::Values(
        Flat{"ReflexCornerOnADiagonal", {{-1, -1}, {1, -1}, {1, 0}, {0, 0}, {0, 1}, {-1, 1}}},
        Flat{"Stairs",
             {{-1, -1}, {1, -1}, {1, -0.5}, {0.5, -0.5}, {0.5, 0}, {0, 0}, {0, 0.5}, {-0.5, 0.5},
              {-0.5, 1}, {-1, 1}}},
        Flat{"Plus",
             {{-0.3, -1}, {0.3, -1}, {0.3, -0.3}, {1, -0.3}, {1, 0.3}, {0.3, 0.3}, {0.3, 1},
              {-0.3, 1}, {-0.3, 0.3}, {-1, 0.3}, {-1, -0.3}, {-0.3, -0.3}}},
        Flat{"Horseshoe",
             {{-1, -1}, {1, -1}, {1, 1}, {0.5, 1}, {0.5, -0.5}, {-0.5, -0.5}, {-0.5, 1}, {-1, 1}}},
        Flat{"SideWithACornerInIt", {{-1, -1}, {0, -1}, {1, -1}, {1, 1}, {-1, 1}}},
        Flat{"Arrowhead", {{-1, -1}, {0, -0.5}, {1, -1}, {0, 1}}},
        Flat{"ArrowheadFromItsNotch", {{0, -0.5}, {1, -1}, {0, 1}, {-1, -1}}},
        Flat{"ThreeCornersOfAQuadOnALine", {{-1, -1}, {0, -1}, {1, -1}, {0, 1}}},
        Flat{"Pentagon", {{0, -1}, {0.95, -0.31}, {0.59, 0.81}, {-0.59, 0.81}, {-0.95, -0.31}}}),
    [](const auto& shape) { return std::string(shape.param.name); });

TEST(Polygon, OutlineThatCrossesItself_IsFilledWithAVertexAtEachCrossing) {
    const auto mesh = loaded("five.obj", "v 0 1 0\nv -0.588 -0.809 0\nv 0.951 0.309 0\n"
                                         "v -0.951 0.309 0\nv 0.588 -0.809 0\nf 1 2 3 4 5\n");
    ASSERT_TRUE(mesh) << mesh.error().text();
    EXPECT_EQ((*mesh)->view().vertices.size(), 10u);
    for (const Vertex& vertex : (*mesh)->view().vertices) {
        EXPECT_NEAR(vertex.normal.z, 1.0f, 1e-6f);
    }
}

TEST(Polygon, HoleOnABridge_StaysOpen) {
    const std::vector<glm::dvec2> outline{{-1, -1},    {1, -1},    {1, 1},      {-1, 1},
                                          {-1, -1},    {-0.5, -0.5}, {-0.5, 0.5}, {0.5, 0.5},
                                          {0.5, -0.5}, {-0.5, -0.5}};
    const auto mesh = loaded("frame.obj", objOf(outline));
    ASSERT_TRUE(mesh) << mesh.error().text();
    double area = 0.0;
    for (const std::vector<glm::dvec2>& triangle : trianglesOf((*mesh)->view())) {
        area += areaOf(triangle);
    }
    EXPECT_NEAR(area, 3.0, 1e-6);
}

TEST(Polygon, InAPlyFile_IsCutTheSameWay) {
    const auto mesh =
        loaded("L.ply", "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\n"
                        "property float y\nproperty float z\nelement face 1\n"
                        "property list uchar int vertex_indices\nend_header\n"
                        "-1 -1 0\n1 -1 0\n1 0 0\n0 0 0\n0 1 0\n-1 1 0\n6 0 1 2 3 4 5\n");
    ASSERT_TRUE(mesh) << mesh.error().text();
    double area = 0.0;
    for (const std::vector<glm::dvec2>& triangle : trianglesOf((*mesh)->view())) {
        area += areaOf(triangle);
    }
    EXPECT_NEAR(area, 3.0, 1e-6);
}

TEST(Polygon, CornersAtOnePlace_AreNothingToDraw) {
    EXPECT_EQ(complaintAbout("point.obj", "v 1 1 1\nf 1 1 1 1 1\n"),
              "none of its 3 triangles can be drawn: they have no area");
}

TEST(Polygon, CornerAtNan_LeavesTheOthers) {
    const auto mesh = loaded("nan.obj", std::string(squareObj) + "v nan 0 0\nf 1 2 3 4 5\n");
    ASSERT_TRUE(mesh) << mesh.error().text();
    EXPECT_NE((*mesh)->remarks().find("no finite position"), std::string::npos);
}

} // namespace
} // namespace patina::tests::polygon_test
