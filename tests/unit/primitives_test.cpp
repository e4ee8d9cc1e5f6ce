// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/primitives.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "scene/builtin_mesh.h"

namespace patina::primitives_test {
namespace {

class Primitive : public testing::TestWithParam<std::string> {
  protected:
    Mesh mesh = primitive(GetParam()).value();
};

std::string nameOf(const testing::TestParamInfo<std::string>& info) {
    return info.param;
}

INSTANTIATE_TEST_SUITE_P(All, Primitive, testing::ValuesIn(primitiveNames()), nameOf);

TEST_P(Primitive, Bounds_LieWithinAboutOneMetreOfTheOrigin) {
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_GE(mesh.bounds.lower[axis], -1.05f);
        EXPECT_LE(mesh.bounds.upper[axis], 1.05f);
    }
    EXPECT_GT(glm::length(mesh.bounds.size()), 1.5f);
}

TEST_P(Primitive, Frames_AreOrthonormal) {
    for (const Vertex& vertex : mesh.vertices) {
        const glm::vec3 tangent(vertex.tangent);
        ASSERT_NEAR(glm::length(vertex.normal), 1.0f, 1e-6f);
        ASSERT_NEAR(glm::length(tangent), 1.0f, 1e-6f);
        ASSERT_NEAR(glm::dot(vertex.normal, tangent), 0.0f, 1e-6f);
        ASSERT_EQ(std::abs(vertex.tangent.w), 1.0f);
    }
}

TEST_P(Primitive, Triangles_FaceTheWayTheirNormalsPoint) {
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const Vertex& a = mesh.vertices.at(mesh.indices[i]);
        const Vertex& b = mesh.vertices.at(mesh.indices[i + 1]);
        const Vertex& c = mesh.vertices.at(mesh.indices[i + 2]);
        const glm::vec3 face = glm::cross(b.position - a.position, c.position - a.position);
        ASSERT_GT(glm::length(face), 0.0f);
        ASSERT_GT(glm::dot(face, a.normal + b.normal + c.normal), 0.0f) << "triangle " << i / 3;
    }
}

TEST_P(Primitive, TextureCoordinates_FollowTheTangentFrame) {
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const Vertex& a = mesh.vertices[mesh.indices[i]];
        const Vertex& b = mesh.vertices[mesh.indices[i + 1]];
        const Vertex& c = mesh.vertices[mesh.indices[i + 2]];
        const glm::vec2 ab = b.uv - a.uv;
        const glm::vec2 ac = c.uv - a.uv;
        const float area = ab.x * ac.y - ab.y * ac.x;
        const glm::vec3 alongU =
            (ac.y * (b.position - a.position) - ab.y * (c.position - a.position)) / area;
        const glm::vec3 alongV =
            (ab.x * (c.position - a.position) - ac.x * (b.position - a.position)) / area;
        const glm::vec3 tangent(a.tangent);
        ASSERT_GT(glm::dot(alongU, tangent), 0.0f) << "triangle " << i / 3;
        ASSERT_GT(glm::dot(alongV, a.tangent.w * glm::cross(a.normal, tangent)), 0.0f)
            << "triangle " << i / 3;
    }
}

/// Share of the edges, by position, that two triangles use in opposite directions.
double closedShare(const Mesh& mesh) {
    using Key = std::array<long, 6>;
    const auto key = [&](std::uint32_t from, std::uint32_t to) {
        Key edge{};
        for (int axis = 0; axis < 3; ++axis) {
            const auto place = static_cast<std::size_t>(axis);
            edge[place] = std::lround(mesh.vertices[from].position[axis] * 1e5f);
            edge[place + 3] = std::lround(mesh.vertices[to].position[axis] * 1e5f);
        }
        return edge;
    };
    std::map<Key, int> balance;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        for (std::size_t side = 0; side < 3; ++side) {
            const std::uint32_t from = mesh.indices[i + side];
            const std::uint32_t to = mesh.indices[i + (side + 1) % 3];
            ++balance[key(from, to)];
            --balance[key(to, from)];
        }
    }
    const auto closed =
        std::ranges::count_if(balance, [](const auto& entry) { return entry.second == 0; });
    return static_cast<double>(closed) / static_cast<double>(balance.size());
}

TEST(Primitives, Solids_HaveNoHoles) {
    for (const char* name :
         {"sphere", "torus", "cube", "cylinder", "cone", "brilliant", "emeraldcut"}) {
        EXPECT_EQ(closedShare(primitive(name).value()), 1.0) << name;
    }
}

TEST(Primitives, ShaderballsOnlyOpenEdge_IsTheNeckInsideTheBall) {
    EXPECT_GT(closedShare(primitive("shaderball").value()), 0.995);
}

Object objectOf(const std::string& mesh) {
    Object object;
    object.mesh = mesh;
    return object;
}

TEST(BuiltinMesh, FittedIntoTheUnitBox_IsCentredAndTwoMetresLong) {
    Object object = objectOf("builtin:cylinder");
    object.fitUnitBox = true;
    const Bounds bounds = builtinMesh(object).value().bounds;
    const glm::vec3 size = bounds.size();
    EXPECT_NEAR(std::max({size.x, size.y, size.z}), 2.0f, 1e-6f);
    EXPECT_LT(glm::length(bounds.center()), 1e-6f);
}

TEST(BuiltinMesh, Flipped_TurnsNormalsAndTriangles) {
    Object object = objectOf("builtin:cube");
    const Mesh upright = builtinMesh(object).value();
    object.flipNormals = true;
    const Mesh flipped = builtinMesh(object).value();
    EXPECT_EQ(flipped.vertices[0].normal, -upright.vertices[0].normal);
    EXPECT_EQ(flipped.vertices[0].tangent.w, -upright.vertices[0].tangent.w);
    EXPECT_EQ(flipped.indices[0], upright.indices[0]);
    EXPECT_EQ(flipped.indices[1], upright.indices[2]);
    EXPECT_EQ(flipped.indices[2], upright.indices[1]);
}

TEST(BuiltinMesh, UnknownName_NamesTheKnownOnes) {
    const auto mesh = builtinMesh(objectOf("builtin:teapot"));
    ASSERT_FALSE(mesh.has_value());
    EXPECT_NE(mesh.error().expected.find("shaderball"), std::string::npos);
}

TEST(Primitives, UnknownName_GivesNothing) {
    EXPECT_FALSE(primitive("teapot").has_value());
}

} // namespace
} // namespace patina::primitives_test
