// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh_openness.h"

#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "scene/kept_openness.h"
#include "scene/primitives.h"
#include "support/program.h"

namespace patina::mesh_openness_test {
namespace {

namespace fs = std::filesystem;
using tests::readFile;
using tests::TemporaryFolder;
using tests::writeFile;

constexpr float exact = 2.0f / 32767.0f;

/// A square of so many squares per side, from `origin` along two edges; its normals point along
/// their cross product.
void addSquare(Mesh& mesh, const glm::vec3& origin, const glm::vec3& u, const glm::vec3& v,
               int side = 8) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (int y = 0; y <= side; ++y) {
        for (int x = 0; x <= side; ++x) {
            Vertex vertex;
            vertex.position = origin + u * (float(x) / float(side)) + v * (float(y) / float(side));
            vertex.normal = glm::normalize(glm::cross(u, v));
            mesh.vertices.push_back(vertex);
        }
    }
    const auto row = static_cast<std::uint32_t>(side + 1);
    for (std::uint32_t y = 0; y + 1 < row; ++y) {
        for (std::uint32_t x = 0; x + 1 < row; ++x) {
            const std::uint32_t at = first + y * row + x;
            mesh.indices.insert(mesh.indices.end(),
                                {at, at + 1, at + row + 1, at, at + row + 1, at + row});
        }
    }
    mesh.bounds = boundsOf(mesh.vertices);
}

std::vector<Openness> opennessAt(const Mesh& mesh) {
    const std::vector<VertexOpenness> packed = opennessOf(mesh.view());
    std::vector<Openness> all;
    for (std::size_t i = 0; i < packed.size(); ++i) {
        all.push_back(unpacked(packed[i], mesh.vertices[i].normal));
    }
    return all;
}

/// The vertex nearest to a point that has this normal.
std::size_t vertexAt(const Mesh& mesh, const glm::vec3& point, const glm::vec3& normal) {
    std::size_t best = 0;
    float least = std::numeric_limits<float>::infinity();
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        const float distance = glm::distance(mesh.vertices[i].position, point) +
                               glm::distance(mesh.vertices[i].normal, normal);
        if (distance < least) {
            least = distance;
            best = i;
        }
    }
    return best;
}

/// The six sides of a cube from -1 to 1, seen from outside or from inside.
Mesh box(bool isInside) {
    Mesh mesh;
    const float s = isInside ? -1.0f : 1.0f;
    for (int axis = 0; axis < 3; ++axis) {
        for (const float side : {-1.0f, 1.0f}) {
            glm::vec3 n(0.0f);
            glm::vec3 u(0.0f);
            n[axis] = side;
            u[(axis + 1) % 3] = 2.0f;
            const glm::vec3 v = s * glm::cross(n, u);
            addSquare(mesh, n - 0.5f * (u + v), u, v);
        }
    }
    return mesh;
}

/// A floor between two walls of height 1, half a metre apart and long.
Mesh groove() {
    Mesh mesh;
    addSquare(mesh, {-0.25f, 0.0f, 20.0f}, {0.5f, 0.0f, 0.0f}, {0.0f, 0.0f, -40.0f}, 16);
    addSquare(mesh, {-0.25f, 1.0f, 20.0f}, {0.0f, -1.0f, 0.0f}, {0.0f, 0.0f, -40.0f}, 16);
    addSquare(mesh, {0.25f, 0.0f, 20.0f}, {0.0f, 1.0f, 0.0f}, {0.0f, 0.0f, -40.0f}, 16);
    return mesh;
}

TEST(MeshOpenness, ConvexShapes_HideNothing) {
    for (const char* name : {"plane", "sphere", "cube", "cylinder"}) {
        const Mesh mesh = primitive(name).value();
        for (const VertexOpenness& each : opennessOf(mesh.view())) {
            ASSERT_EQ(each, VertexOpenness()) << name;
        }
    }
    for (const Openness& each : opennessAt(primitive("cone").value())) {
        ASSERT_NEAR(each.share, 1.0f, exact); // a tip has no room for a back
    }
}

TEST(MeshOpenness, InsideOfABox_SeesNothing) {
    const Mesh mesh = box(true);
    for (const Openness& each : opennessAt(mesh)) {
        EXPECT_NEAR(each.share, 0.0f, 0.02f);
    }
    for (const Openness& each : opennessAt(box(false))) {
        EXPECT_NEAR(each.share, 1.0f, exact);
    }
}

/// The cosine-weighted share that two long walls of height h leave of a floor of width w, in its
/// middle: sin of the angle to their upper edges, w / sqrt(w^2 + 4 h^2).
TEST(MeshOpenness, MiddleOfAGroove_SeesTheShareBetweenItsEdges) {
    const Mesh mesh = groove();
    const std::size_t at = vertexAt(mesh, {0.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f});
    const Openness found = opennessAt(mesh)[at];
    EXPECT_NEAR(found.share, 0.5 / std::sqrt(0.25 + 4.0), 0.02);
    EXPECT_GT(found.direction.y, 0.99f);
}

TEST(MeshOpenness, SidesOfAGroove_LookOutOfIt) {
    const Mesh mesh = groove();
    const std::size_t at = vertexAt(mesh, {0.25f, 0.5f, 0.0f}, {-1.0f, 0.0f, 0.0f});
    const Openness found = opennessAt(mesh)[at];
    EXPECT_LT(found.share, 0.4f);
    EXPECT_GT(found.direction.y, 0.7f);
}

/// Half of all directions, by their cosine, where floor and wall meet: of those that are left the
/// mean leans away from the wall by atan((2 / 3) / (pi / 3)).
TEST(MeshOpenness, CornerOfFloorAndWall_SeesHalf) {
    Mesh mesh;
    addSquare(mesh, {0.0f, 0.0f, 20.0f}, {20.0f, 0.0f, 0.0f}, {0.0f, 0.0f, -40.0f});
    addSquare(mesh, {0.0f, 20.0f, 20.0f}, {0.0f, -20.0f, 0.0f}, {0.0f, 0.0f, -40.0f});
    const std::size_t at = vertexAt(mesh, {0.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f});
    const Openness found = opennessAt(mesh)[at];
    EXPECT_NEAR(found.share, 0.5f, 0.05f);
    EXPECT_NEAR(std::atan2(found.direction.x, found.direction.y), std::atan(2.0 / M_PI), 0.06);
}

/// A sphere of radius r whose middle is at the height r above the point hides sin^2 of the angle
/// that it takes, from the point below a sphere that hovers: (r / d)^2.
TEST(MeshOpenness, FloorUnderASphere_LacksWhatTheSphereTakes) {
    Mesh mesh = primitive("sphere").value();
    const float radius = mesh.bounds.upper.y;
    addSquare(mesh, {-8.0f, -2.0f * radius, 8.0f}, {16.0f, 0.0f, 0.0f}, {0.0f, 0.0f, -16.0f}, 16);
    const std::vector<Openness> all = opennessAt(mesh);
    const glm::vec3 up(0.0f, 1.0f, 0.0f);
    const std::size_t below = vertexAt(mesh, {0.0f, -2.0f * radius, 0.0f}, up);
    const std::size_t away = vertexAt(mesh, {8.0f, -2.0f * radius, 8.0f}, up);
    EXPECT_NEAR(all[below].share, 0.75f, 0.02f);
    EXPECT_GT(all[away].share, 0.97f);
}

/// A shell without thickness has an inside that is seen from behind.
TEST(MeshOpenness, BackOfAnOpenBox_IsDarkerThanItsFront) {
    Mesh mesh = box(false);
    const std::size_t side = mesh.indices.size() / 6;
    mesh.indices.resize(5 * side); // one side is open
    const std::size_t bottom = vertexAt(mesh, {0.0f, 0.0f, -1.0f}, {0.0f, 0.0f, -1.0f});
    const Openness found = opennessAt(mesh)[bottom];
    EXPECT_NEAR(found.share, 1.0f, exact);
    EXPECT_GT(found.back, 0.05f);
    EXPECT_LT(found.back, 0.4f);
}

TEST(MeshOpenness, PlaceAndSize_ChangeNothing) {
    const Mesh mesh = groove();
    Mesh far = mesh;
    for (Vertex& vertex : far.vertices) {
        vertex.position = vertex.position * 1024.0f + glm::vec3(65536.0f, 0.0f, -32768.0f);
    }
    const std::size_t at = vertexAt(mesh, {0.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f});
    EXPECT_NEAR(opennessAt(far)[at].share, opennessAt(mesh)[at].share, 0.01f);
}

TEST(MeshOpenness, WhatIsNoSurface_HidesNothing) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float inf = std::numeric_limits<float>::infinity();
    Mesh point;
    point.vertices.resize(3);
    point.indices = {0, 1, 2};
    Mesh broken = groove();
    broken.vertices[0].position = {nan, inf, -inf};
    broken.vertices[1].normal = {nan, 0.0f, 0.0f};
    broken.vertices[2].normal = glm::vec3(0.0f);
    broken.vertices[3].position = glm::vec3(3e38f);
    broken.indices[5] = 1u << 31; // beyond the vertices
    broken.indices.push_back(0);
    EXPECT_TRUE(opennessOf(MeshView()).empty());
    EXPECT_EQ(opennessOf(point.view()), std::vector<VertexOpenness>(3));
    const std::vector<Openness> all = opennessAt(broken);
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (!std::isnan(broken.vertices[i].normal.x)) {
            EXPECT_GE(all[i].share, 0.0f) << i;
            EXPECT_LE(all[i].share, 1.0f) << i;
        }
        EXPECT_GE(all[i].back, 0.0f) << i;
        EXPECT_LE(all[i].back, 1.0f) << i;
    }
    for (const int i : {0, 1, 2}) {
        EXPECT_EQ(opennessOf(broken.view())[std::size_t(i)], VertexOpenness()) << i;
    }
}

TEST(MeshOpenness, Cancelled_IsEmpty) {
    Progress progress;
    progress.cancelled = true;
    EXPECT_TRUE(opennessOf(groove().view(), &progress).empty());
}

class KeptOpenness : public testing::Test {
  protected:
    std::vector<VertexOpenness> kept() { return keptOpenness(mesh_.view(), folder_.path()); }
    fs::path file() { return opennessFile(mesh_.view(), folder_.path()); }

    TemporaryFolder folder_;
    Mesh mesh_ = groove();
    std::vector<VertexOpenness> right_ = opennessOf(mesh_.view());
};

/// A file of other numbers that is whole is believed: it was read, not made again.
TEST_F(KeptOpenness, File_IsReadBack) {
    EXPECT_EQ(kept(), right_);
    const std::string content = readFile(file());
    Mesh other = mesh_;
    other.vertices[0].position.y += 0.25f;
    const fs::path place = opennessFile(other.view(), folder_.path());
    ASSERT_NE(place, file());
    writeFile(place, content);
    EXPECT_EQ(keptOpenness(other.view(), folder_.path()), right_);
}

TEST_F(KeptOpenness, DamagedFile_IsMadeAgain) {
    kept();
    const std::string whole = readFile(file());
    std::string flipped = whole;
    flipped[whole.size() / 2] ^= 0x10;
    for (const std::string& damaged :
         {std::string(), whole.substr(0, whole.size() / 2), whole + 'x', flipped}) {
        writeFile(file(), damaged);
        EXPECT_EQ(kept(), right_);
        EXPECT_EQ(readFile(file()), whole);
    }
}

TEST_F(KeptOpenness, NoFolder_KeepsNothing) {
    EXPECT_EQ(keptOpenness(mesh_.view(), {}), right_);
    writeFile(folder_ / "file", "");
    EXPECT_EQ(keptOpenness(mesh_.view(), folder_ / "file"), right_);
}

} // namespace
} // namespace patina::mesh_openness_test
