// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh_curvature.h"

#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "scene/primitives.h"

namespace patina::mesh_curvature_test {
namespace {

std::vector<VertexCurvature> curvaturesOf(const Mesh& mesh, std::size_t items) {
    CurvatureFinder finder(mesh.view());
    while (!finder.isDone()) {
        finder.proceed(mesh.view(), items);
    }
    return finder.curvatures();
}

glm::vec3 along(const VertexCurvature& c, const glm::vec3& x) {
    return {c.diagonal.x * x.x + c.mixed.x * x.y + c.mixed.z * x.z,
            c.mixed.x * x.x + c.diagonal.y * x.y + c.mixed.y * x.z,
            c.mixed.z * x.x + c.mixed.y * x.y + c.diagonal.z * x.z};
}

/// A tube about y with normals outward.
Mesh tube(float radius) {
    Mesh mesh;
    constexpr std::uint32_t around = 256;
    for (std::uint32_t row = 0; row < 8; ++row) {
        for (std::uint32_t i = 0; i <= around; ++i) {
            const float angle = 6.2831853f * float(i) / float(around);
            Vertex vertex;
            vertex.normal = {std::cos(angle), 0.0f, std::sin(angle)};
            vertex.position = radius * vertex.normal + glm::vec3(0.0f, 0.2f * float(row), 0.0f);
            mesh.vertices.push_back(vertex);
        }
    }
    for (std::uint32_t row = 0; row + 1 < 8; ++row) {
        for (std::uint32_t i = 0; i < around; ++i) {
            const std::uint32_t at = row * (around + 1) + i;
            const std::uint32_t above = at + around + 1;
            mesh.indices.insert(mesh.indices.end(), {at, above, at + 1, at + 1, above, above + 1});
        }
    }
    mesh.bounds = boundsOf(mesh.vertices);
    return mesh;
}

TEST(MeshCurvature, OfATube_IsThatOfItsCircleAround) {
    const Mesh mesh = tube(0.5f);
    const std::vector<VertexCurvature> all = curvaturesOf(mesh, 1000);
    for (std::size_t i = 0; i < all.size(); ++i) {
        const glm::vec3 n = mesh.vertices[i].normal;
        const glm::vec3 around(-n.z, 0.0f, n.x);
        EXPECT_NEAR(glm::dot(around, along(all[i], around)), 2.0f, 0.02f);
        EXPECT_LT(glm::length(along(all[i], glm::vec3(0.0f, 1.0f, 0.0f))), 0.02f);
        EXPECT_LT(glm::length(along(all[i], n)), 1e-4f);
    }
}

TEST(MeshCurvature, OfASphere_IsTheSameInAllDirections) {
    const Mesh mesh = *primitive("sphere");
    const std::vector<VertexCurvature> all = curvaturesOf(mesh, 100000);
    for (std::size_t i = 0; i < all.size(); i += 7) {
        const glm::vec3 n = mesh.vertices[i].normal;
        const glm::vec3 side = glm::normalize(
            glm::cross(n, std::abs(n.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0)));
        EXPECT_NEAR(glm::dot(side, along(all[i], side)), 1.0f, 0.1f) << i;
    }
}

TEST(MeshCurvature, HoweverTheWorkIsCut_IsTheSame) {
    const Mesh mesh = tube(0.5f);
    EXPECT_EQ(curvaturesOf(mesh, 7), curvaturesOf(mesh, 1000000));
}

TEST(MeshCurvature, OfWhatHasNoAreaOrIsNotFinite_IsFlat) {
    Mesh mesh = tube(0.5f);
    mesh.vertices[3].position.x = std::numeric_limits<float>::quiet_NaN();
    mesh.vertices[20].normal = glm::vec3(std::numeric_limits<float>::infinity());
    for (std::size_t i = 100; i < 180; ++i) {
        mesh.vertices[i].position = glm::vec3(1e30f);
    }
    mesh.indices.insert(mesh.indices.end(), {0, 0, 0, 1, 2, 4000000000U});
    for (const VertexCurvature& c : curvaturesOf(mesh, 1000)) {
        for (int i = 0; i < 3; ++i) {
            EXPECT_TRUE(std::isfinite(c.diagonal[i]) && std::isfinite(c.mixed[i]));
        }
    }
    EXPECT_TRUE(curvaturesOf(Mesh(), 10).empty());
}

} // namespace
} // namespace patina::mesh_curvature_test
