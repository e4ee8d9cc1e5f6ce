// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/gpu/edge_finder.h"

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

#include "scene/primitives.h"

namespace patina::edge_finder_test {
namespace {

std::vector<MeshEdge> edgesOf(const Mesh& mesh, std::size_t step = 1u << 20) {
    EdgeFinder finder(mesh.view());
    while (!finder.isDone()) {
        finder.proceed(mesh.view(), step);
    }
    return {finder.edges().begin(), finder.edges().end()};
}

std::ptrdiff_t countOpen(const std::vector<MeshEdge>& edges) {
    return std::ranges::count_if(edges, [](const MeshEdge& edge) { return edge[0] == edge[3]; });
}

Mesh meshOf(const std::vector<glm::vec3>& corners, const std::vector<std::uint32_t>& indices) {
    Mesh mesh;
    for (const glm::vec3& corner : corners) {
        mesh.vertices.push_back({corner});
    }
    mesh.indices = indices;
    mesh.bounds = boundsOf(mesh.vertices);
    return mesh;
}

class ClosedPrimitive : public testing::TestWithParam<const char*> {};

TEST_P(ClosedPrimitive, EveryEdge_HasTwoFaces) {
    const Mesh mesh = *primitive(GetParam());
    const std::vector<MeshEdge> edges = edgesOf(mesh);
    EXPECT_EQ(countOpen(edges), 0);
    EXPECT_EQ(2 * edges.size(), mesh.indices.size());
}

INSTANTIATE_TEST_SUITE_P(EdgeFinder, ClosedPrimitive,
                         testing::Values("sphere", "cube", "torus", "cylinder", "cone"));

TEST(EdgeFinder, Plane_IsOpenAlongItsSides) {
    const std::vector<MeshEdge> edges = edgesOf(*primitive("plane"));
    EXPECT_EQ(countOpen(edges), 4 * 16);
    EXPECT_EQ(edges.size(), 2u * 16 * 17 + 16 * 16);
}

TEST(EdgeFinder, Shaderball_IsOpenAtItsNeckAlone) {
    EXPECT_EQ(countOpen(edgesOf(*primitive("shaderball"))), 128);
}

TEST(EdgeFinder, Steps_DoNotShow) {
    const Mesh mesh = *primitive("cone");
    EXPECT_EQ(edgesOf(mesh, 7), edgesOf(mesh));
}

TEST(EdgeFinder, Edge_NamesTheCornersOfItsFaces) {
    const Mesh mesh = meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {0, 1, 2, 1, 3, 2});
    const std::vector<MeshEdge> edges = edgesOf(mesh);
    EXPECT_EQ(std::ranges::count(edges, MeshEdge{0, 1, 2, 3}), 1);
    EXPECT_EQ(edges.size(), 5u);
}

TEST(EdgeFinder, VerticesAtOnePlace_AreOne) {
    const Mesh mesh = meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, -0.0f, -0.0f}, {1, 1, 0},
                              {0, 1, 0}}, {0, 1, 2, 3, 4, 5});
    EXPECT_EQ(edgesOf(mesh).size(), 5u);
}

TEST(EdgeFinder, FoldedTriangle_CountsForNothing) {
    const Mesh mesh = meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}},
                             {0, 1, 2, 1, 3, 0});
    EXPECT_EQ(edgesOf(mesh).size(), 3u);
}

TEST(EdgeFinder, EdgeOfThreeOrFourFaces_CountsAsOpen) {
    const std::vector<glm::vec3> corners{{0, 0, 0}, {0, 0, 1}, {1, 0, 0},
                                         {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
    const Mesh three = meshOf(corners, {0, 1, 2, 0, 1, 3, 0, 1, 4});
    const Mesh four = meshOf(corners, {0, 1, 2, 0, 1, 3, 0, 1, 4, 0, 1, 5});
    EXPECT_EQ(countOpen(edgesOf(three)), 7);
    EXPECT_EQ(countOpen(edgesOf(four)), 9);
}

TEST(EdgeFinder, PlacesThatAreNoNumbers_AreEachTheirOwn) {
    const float none = std::numeric_limits<float>::quiet_NaN();
    const Mesh mesh = meshOf({{0, 0, 0}, {1, 0, 0}, {none, 0, 0}, {none, 0, 0}},
                             {0, 1, 2, 0, 1, 3});
    EXPECT_EQ(edgesOf(mesh).size(), 5u);
}

} // namespace
} // namespace patina::edge_finder_test
