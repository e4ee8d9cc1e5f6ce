// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/convex_facets.h"

#include <algorithm>
#include <ctime>
#include <limits>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "scene/primitives.h"

namespace patina::convex_facets_test {
namespace {

ConvexFacets facetsOf(const Mesh& mesh) {
    return convexFacetsOf(mesh.view());
}

TEST(ConvexFacets, OfACube_AreItsSixSides) {
    const ConvexFacets facets = facetsOf(*primitive("cube")); // of 768 triangles
    EXPECT_EQ(facets.whyNot, "");
    ASSERT_EQ(facets.planes.size(), 6u);
    for (const FacetPlane& plane : facets.planes) {
        EXPECT_NEAR(glm::length(plane.normal), 1.0, 1e-12);
        EXPECT_NEAR(plane.offset, 0.75, 1e-6);
    }
}

TEST(ConvexFacets, OfGems_AreThoseOfTheirCuts) {
    EXPECT_EQ(facetsOf(*primitive("brilliant")).planes.size(), 57u + 32u);
    EXPECT_EQ(facetsOf(*primitive("emeraldcut")).planes.size(), 49u + 8u);
}

TEST(ConvexFacets, FarFromTheOrigin_AreWhereTheMeshIs) {
    Mesh mesh = *primitive("cube");
    for (Vertex& vertex : mesh.vertices) {
        vertex.position += glm::vec3(100.0f, 0.0f, 0.0f);
    }
    mesh.bounds = boundsOf(mesh.vertices);
    const ConvexFacets facets = facetsOf(mesh);
    ASSERT_EQ(facets.planes.size(), 6u);
    EXPECT_NEAR(std::ranges::max(facets.planes, {}, &FacetPlane::offset).offset, 100.75, 1e-3);
}

TEST(ConvexFacets, OfAMeshInsideOut_PointOutwardAllTheSame) {
    Mesh mesh = *primitive("cube");
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        std::swap(mesh.indices[i], mesh.indices[i + 1]);
    }
    const ConvexFacets facets = facetsOf(mesh);
    ASSERT_EQ(facets.planes.size(), 6u);
    for (const FacetPlane& plane : facets.planes) {
        EXPECT_NEAR(plane.offset, 0.75, 1e-6);
    }
}

TEST(ConvexFacets, OfARoundMesh_AreTooMany) {
    EXPECT_EQ(facetsOf(*primitive("sphere")).whyNot, "it has more than 128 flat facets");
}

TEST(ConvexFacets, OfAMeshWithDents_AreNone) {
    Mesh mesh = *primitive("cube");
    const Mesh other = mesh;
    for (const std::uint32_t index : other.indices) {
        mesh.indices.push_back(index + static_cast<std::uint32_t>(other.vertices.size()));
    }
    for (Vertex vertex : other.vertices) {
        vertex.position += glm::vec3(2.0f, 0.5f, 0.0f);
        mesh.vertices.push_back(vertex);
    }
    mesh.bounds = boundsOf(mesh.vertices);
    const ConvexFacets facets = facetsOf(mesh);
    EXPECT_EQ(facets.whyNot, "it is not convex");
    EXPECT_TRUE(facets.planes.empty());
}

/// A cube's squares follow each other, side by side: +x, -x, +y, ...
TEST(ConvexFacets, OfAMeshWithoutSomeOfItsSides_AreNone) {
    const Mesh cube = *primitive("cube");
    const auto side = std::ptrdiff_t(cube.indices.size() / 6);
    for (const int missing : {1, 2, 4, 5}) {
        Mesh open = cube;
        open.indices.erase(open.indices.begin(), open.indices.begin() + missing * side);
        EXPECT_EQ(facetsOf(open).whyNot, "it is not closed") << missing;
    }
}

TEST(ConvexFacets, OfOneTriangle_AreNone) {
    Mesh mesh;
    mesh.vertices.resize(3);
    mesh.vertices[1].position.x = 1.0f;
    mesh.vertices[2].position.y = 1.0f;
    mesh.indices = {0, 1, 2};
    mesh.bounds = boundsOf(mesh.vertices);
    EXPECT_EQ(facetsOf(mesh).whyNot, "it is not closed");
}

TEST(ConvexFacets, OfNothing_AreNone) {
    EXPECT_EQ(facetsOf(Mesh()).whyNot, "it has no extent");
}

TEST(ConvexFacets, OfPlacesThatAreNoNumbers_AreNone) {
    for (const float value :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        Mesh mesh = *primitive("cube");
        mesh.vertices[40].position.x = value;
        mesh.bounds = boundsOf(mesh.vertices);
        EXPECT_TRUE(facetsOf(mesh).planes.empty());
    }
}

/// Returns a cube of so many squares along each edge.
Mesh fineCube(std::uint32_t squares) {
    Mesh mesh;
    const Mesh coarse = *primitive("cube");
    const std::size_t corners = coarse.vertices.size() / 6;
    const std::uint32_t row = squares + 1;
    for (std::size_t side = 0; side < 6; ++side) {
        const Vertex& first = coarse.vertices[side * corners];
        const glm::vec3 u = 1.5f * glm::vec3(first.tangent);
        const glm::vec3 v = glm::cross(first.normal, u);
        const auto start = static_cast<std::uint32_t>(mesh.vertices.size());
        for (std::uint32_t i = 0; i < row * row; ++i) {
            Vertex vertex = first;
            vertex.position +=
                u * (float(i % row) / float(squares)) + v * (float(i / row) / float(squares));
            mesh.vertices.push_back(vertex);
        }
        for (std::uint32_t i = 0; i < squares * squares; ++i) {
            const std::uint32_t at = start + i / squares * row + i % squares;
            mesh.indices.insert(mesh.indices.end(),
                                {at, at + 1, at + row + 1, at, at + row + 1, at + row});
        }
    }
    mesh.bounds = boundsOf(mesh.vertices);
    return mesh;
}

TEST(ConvexFacets, OfAMillionTriangles_AreNotLookedFor) {
    const Mesh mesh = fineCube(300);
    ASSERT_GT(mesh.indices.size(), 3'000'000u);
    EXPECT_EQ(facetsOf(mesh).whyNot, "it has more than 100000 triangles");
}

/// Takes 0.03 s of processor time, 0.4 s under sanitizers; comparing all pairs would take minutes.
TEST(ConvexFacets, OfManyTriangles_AreFoundWithoutComparingAllPairs) {
    const Mesh mesh = fineCube(90); // 97 200 triangles
    const std::clock_t start = std::clock();
    EXPECT_EQ(facetsOf(mesh).planes.size(), 6u);
    EXPECT_LT(std::clock() - start, CLOCKS_PER_SEC);
}

} // namespace
} // namespace patina::convex_facets_test
