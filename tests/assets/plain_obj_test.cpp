// SPDX-License-Identifier: GPL-3.0-or-later
// Plain OBJ files are read by another library than the others: it must not show.
#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "mesh_files.h"

namespace patina::tests::plain_obj_test {
namespace {

constexpr float objTolerance = 1e-6f; // one rounding of a decimal number near one

constexpr const char* tent =
    "# a tent\nmtllib tent.mtl\no tent\ng sides\nusemtl cloth\ns off\n"
    "v 0.1 0 0\r\nv 1 0 0.1\nv\t1 1 0.5\nv 0 1 -0.25\n"
    "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 1\nvn 0 1 0\n"
    "f 1/1/1 2/2/1 3/3/2\nf 1/1/1 3/3/2 4/4/2\n";

/// A point that no face uses, in a form of the format that goes to the other library.
constexpr const char* homogeneousPoint = "v 0 0 0 1\n";

using Corner = std::array<float, 8>;

/// What the triangles are made of, in an order that does not depend on how vertices are numbered.
std::vector<std::array<Corner, 3>> trianglesOf(const MeshView& mesh) {
    std::vector<std::array<Corner, 3>> triangles(mesh.indices.size() / 3);
    for (std::size_t i = 0; i < 3 * triangles.size(); ++i) {
        const Vertex& v = mesh.vertices[mesh.indices[i]];
        triangles[i / 3][i % 3] = {v.position.x, v.position.y, v.position.z, v.normal.x,
                                   v.normal.y,   v.normal.z,   v.uv.x,       v.uv.y};
    }
    for (auto& triangle : triangles) {
        std::rotate(triangle.begin(), std::ranges::min_element(triangle), triangle.end());
    }
    std::ranges::sort(triangles);
    return triangles;
}

TEST(PlainObj, EqualsWhatTheGeneralReaderMakesOfIt) {
    const auto plain = loaded("tent.obj", tent);
    const auto general = loaded("tent.obj", std::string(tent).append(homogeneousPoint));
    ASSERT_TRUE(plain) << plain.error().text();
    ASSERT_TRUE(general) << general.error().text();
    const auto triangles = trianglesOf((*plain)->view());
    const auto expected = trianglesOf((*general)->view());
    ASSERT_EQ(triangles.size(), 2u);
    ASSERT_EQ(expected.size(), 2u);
    for (std::size_t i = 0; i < 6; ++i) {
        for (std::size_t k = 0; k < 8; ++k) {
            EXPECT_NEAR(triangles[i / 3][i % 3][k], expected[i / 3][i % 3][k], objTolerance);
        }
    }
}

TEST(PlainObj, RelativeCorners_CountFromTheEnd) {
    std::string relative = tent;
    const std::string absolute = "f 1/1/1 3/3/2 4/4/2";
    relative.replace(relative.find(absolute), absolute.size(), "f -4/-4/-2 -2/-2/-1 -1/-1/-1");
    const auto expected = loaded("tent.obj", tent);
    const auto mesh = loaded("tent.obj", relative);
    ASSERT_TRUE(mesh) << mesh.error().text();
    EXPECT_EQ(trianglesOf((*mesh)->view()), trianglesOf((*expected)->view()));
}

TEST(PlainObj, NumbersWithExponents_AreRead) {
    const auto mesh = loaded("small.obj", "v 0 0 0\nv 1E-1 0 0\nv 0 2.5e-1 0\nf 1 2 3\n");
    ASSERT_TRUE(mesh) << mesh.error().text();
    EXPECT_EQ((*mesh)->view().bounds.upper, glm::vec3(0.1f, 0.25f, 0.0f));
}

/// What a file with numbers that start with their point reads as, and what it should.
void expectSameMesh(const std::string& bare, const std::string& written) {
    const auto mesh = loaded("bare.obj", bare);
    const auto expected = loaded("written.obj", written);
    ASSERT_TRUE(mesh) << mesh.error().text();
    ASSERT_TRUE(expected) << expected.error().text();
    EXPECT_EQ(trianglesOf((*mesh)->view()), trianglesOf((*expected)->view()));
}

TEST(PlainObj, QuadsOfNumbersThatStartWithTheirPoint_AreRead) {
    expectSameMesh("v 0 0 0\nv .5 0 0\nv +.5 .5e0 0\nv 0 -.5 0\nf 1 2 3 4\n",
                   "v 0 0 0\nv 0.5 0 0\nv +0.5 0.5e0 0\nv 0 -0.5 0\nf 1 2 3 4\n");
}

TEST(PlainObj, TextureCoordinatesThatStartWithTheirPoint_AreRead) {
    expectSameMesh(
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt .1 .2\nvt\t.9 .2\nvt 1 1\nvt 0 .75\n"
        "vn .6 0 .8\nf 1/1/1 2/2/1 3/3/1 4/4/1\n",
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0.1 0.2\nvt 0.9 0.2\nvt 1 1\nvt 0 0.75\n"
        "vn 0.6 0 0.8\nf 1/1/1 2/2/1 3/3/1 4/4/1\n");
}

TEST(PlainObj, PolygonsOfNumbersThatStartWithTheirPoint_AreRead) {
    expectSameMesh("mtllib ./a.mtl\nv .5 0 0\nv 1 .5 0\nv .5 1 0\nv 0 1 0\nv 0 .5 0\n"
                   "usemtl .5\nf 1 2 3 \\\n4 5\n",
                   "v 0.5 0 0\nv 1 0.5 0\nv 0.5 1 0\nv 0 1 0\nv 0 0.5 0\nf 1 2 3 4 5\n");
}

TEST(PlainObj, SharedCorners_StayShared) {
    const auto mesh = loaded("pair.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n");
    ASSERT_TRUE(mesh) << mesh.error().text();
    EXPECT_EQ((*mesh)->view().vertices.size(), 4u);
}

TEST(PlainObj, PlacesWrittenTwice_AreJoined) {
    const auto mesh = loaded(
        "pair.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv -0 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 4 5 6\n");
    ASSERT_TRUE(mesh) << mesh.error().text();
    EXPECT_EQ((*mesh)->view().vertices.size(), 4u);
}

TEST(PlainObj, CornerBeyondTheVertices_IsAMessageOrLeftOut) {
    const auto mesh = loaded("beyond.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\nf 1 2 900\n");
    EXPECT_TRUE(!mesh || (*mesh)->view().indices.size() == 3u);
}

TEST(PlainObj, NumberBeyondFloats_IsLeftOutAndReported) {
    const auto mesh =
        loaded("far.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 1e999 0 0\nf 1 2 3\nf 1 2 4\n");
    ASSERT_TRUE(mesh) << mesh.error().text();
    EXPECT_EQ((*mesh)->view().indices.size(), 3u);
    EXPECT_NE((*mesh)->remarks(), "");
}

TEST(PlainObj, LastLineWithoutAnEnd_Counts) {
    const auto mesh = loaded("short.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3");
    ASSERT_TRUE(mesh) << mesh.error().text();
    EXPECT_EQ((*mesh)->view().indices.size(), 3u);
}

} // namespace
} // namespace patina::tests::plain_obj_test
