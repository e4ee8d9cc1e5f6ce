// SPDX-License-Identifier: GPL-3.0-or-later
// What becomes of good and of poor meshes, through the files process.

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "mesh_files.h"

namespace patina::tests::mesh_test {
namespace {

constexpr float tolerance = 1e-6f; // a few roundings of numbers near one

/// A cube of side 2, every corner once, faces outwards.
constexpr const char* cubeObj =
    "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\n"
    "v -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
    "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 3 4 8 7\nf 2 3 7 6\nf 4 1 5 8\n";

/// The normal the winding of a triangle gives.
glm::vec3 windingNormal(const MeshView& mesh, std::size_t triangle) {
    const auto corner = [&](std::size_t k) {
        return mesh.vertices[mesh.indices[3 * triangle + k]].position;
    };
    return glm::normalize(glm::cross(corner(1) - corner(0), corner(2) - corner(0)));
}

TEST(MeshFile, SquareObj_BecomesTwoTrianglesWithJoinedVertices) {
    const auto mesh = loaded("square.obj", squareObj);
    ASSERT_TRUE(mesh) << mesh.error().text();
    EXPECT_EQ((*mesh)->view().indices.size(), 6u);
    EXPECT_EQ((*mesh)->view().vertices.size(), 4u);
}

TEST(MeshFile, Missing_SaysSo) {
    AssetClient client;
    const auto mesh = client.loadMesh({"/nowhere/at/all.obj"});
    ASSERT_FALSE(mesh);
    EXPECT_EQ(mesh.error().text(), "/nowhere/at/all.obj: no such file");
}

TEST(MeshFile, Folder_SaysSo) {
    AssetClient client;
    const auto mesh = client.loadMesh({"/tmp"});
    ASSERT_FALSE(mesh);
    EXPECT_EQ(mesh.error().problem, "is a folder");
}

TEST(MeshFile, UnknownFormat_SaysSo) {
    EXPECT_EQ(complaintAbout("notes.txt", "hello"), "is not in a mesh format known here");
}

TEST(MeshFile, TextInUtf16_SaysSo) {
    std::string wide("\xff\xfe", 2);
    for (const char c : std::string(squareObj)) {
        wide += {c, '\0'};
    }
    EXPECT_EQ(complaintAbout("wide.obj", wide), "is text in UTF-16");
}

TEST(MeshFile, RelativePath_IsFound) {
    const TemporaryFolder folder;
    writeFile(folder / "square.obj", squareObj);
    AssetClient client;
    const auto mesh = client.loadMesh({std::filesystem::relative(folder / "square.obj")});
    EXPECT_TRUE(mesh) << mesh.error().text();
}

TEST(MeshFile, CubeWithoutNormals_GetsThemSmoothAlongTheDiagonals) {
    const auto mesh = loaded("cube.obj", cubeObj);
    ASSERT_TRUE(mesh) << mesh.error().text();
    for (const Vertex& vertex : (*mesh)->view().vertices) {
        // Angle-weighted, so the two triangles of a face count no more than one would.
        EXPECT_GT(glm::dot(vertex.normal, glm::normalize(vertex.position)), 1.0f - tolerance);
    }
}

TEST(MeshFile, AnyMesh_HasUnitTangentsOrthogonalToItsNormals) {
    const auto mesh = loaded("cube.obj", cubeObj);
    ASSERT_TRUE(mesh) << mesh.error().text();
    for (const Vertex& vertex : (*mesh)->view().vertices) {
        EXPECT_NEAR(glm::length(glm::vec3(vertex.tangent)), 1.0f, tolerance);
        EXPECT_NEAR(glm::dot(glm::vec3(vertex.tangent), vertex.normal), 0.0f, tolerance);
    }
}

TEST(MeshFile, TextureCoordinates_GiveTheTangentAlongU) {
    const auto mesh = loaded("uv.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\nvt 0 1\nvt -1 1\n"
                                       "f 1/1 2/2 3/3\n"); // u falls along y
    ASSERT_TRUE(mesh) << mesh.error().text();
    for (const Vertex& vertex : (*mesh)->view().vertices) {
        EXPECT_NEAR(vertex.tangent.y, -1.0f, tolerance);
        EXPECT_EQ(vertex.tangent.w, 1.0f); // v grows along x = cross(z, -y)
    }
}

TEST(MeshFile, MirroredTexture_SplitsTheSeam) {
    const auto mesh =
        loaded("mirror.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
                             "vt 0 0\nvt 1 0\nvt 1 1\nf 1/1 2/2 3/3\nf 1/1 3/3 4/2\n");
    ASSERT_TRUE(mesh) << mesh.error().text();
    EXPECT_EQ((*mesh)->view().vertices.size(), 6u);
}

TEST(MeshFile, DegenerateTextureCoordinates_FallBackToAStableTangent) {
    const auto mesh = loaded("flat.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0.5 0.5\n"
                                         "f 1/1 2/1 3/1\n");
    ASSERT_TRUE(mesh) << mesh.error().text();
    EXPECT_NEAR((*mesh)->view().vertices[0].tangent.x, 1.0f, tolerance); // around y, facing z
}

TEST(MeshFile, FlippedNormals_TurnTheWindingToo) {
    const auto mesh = loaded("square.obj", squareObj, {.file = {}, .flipNormals = true});
    ASSERT_TRUE(mesh) << mesh.error().text();
    EXPECT_NEAR((*mesh)->view().vertices[0].normal.z, -1.0f, tolerance);
    EXPECT_NEAR(windingNormal((*mesh)->view(), 0).z, -1.0f, tolerance);
}

TEST(MeshFile, FittedToTheUnitBox_IsCentredWithLongestSideTwo) {
    const auto mesh = loaded("far.obj", "v 100 0 0\nv 104 0 0\nv 104 2 0\nf 1 2 3\n",
                             {.file = {}, .fitUnitBox = true});
    ASSERT_TRUE(mesh) << mesh.error().text();
    const Bounds bounds = (*mesh)->view().bounds;
    EXPECT_EQ(bounds.lower, glm::vec3(-1.0f, -0.5f, 0.0f));
    EXPECT_EQ(bounds.upper, glm::vec3(1.0f, 0.5f, 0.0f));
}

TEST(MeshFile, Scaled_GrowsAboutTheOrigin) {
    const auto mesh = loaded("square.obj", squareObj, {.file = {}, .scale = 2.5});
    ASSERT_TRUE(mesh) << mesh.error().text();
    EXPECT_EQ((*mesh)->view().bounds.upper, glm::vec3(2.5f, 2.5f, 0.0f));
}

TEST(MeshFile, ScaleOfZero_IsRefused) {
    const auto mesh = loaded("square.obj", squareObj, {.file = {}, .scale = 0.0});
    ASSERT_FALSE(mesh);
    EXPECT_EQ(mesh.error().problem, "the scale is not usable");
}

TEST(MeshFile, ScaleBeyondTheFloats_IsRefused) {
    EXPECT_FALSE(loaded("square.obj", squareObj, {.file = {}, .scale = 1e300}));
}

TEST(PoorMesh, TriangleAtNan_IsLeftOutAndReported) {
    const auto mesh =
        loaded("nan.obj", std::string(squareObj).append("v nan 0 0\nf 1 2 5\n"));
    ASSERT_TRUE(mesh) << mesh.error().text();
    EXPECT_EQ((*mesh)->view().indices.size(), 6u);
    EXPECT_EQ((*mesh)->remarks(),
              "1 of 3 triangles had no finite position and were left out");
}

TEST(PoorMesh, OnlyNan_SaysSo) {
    EXPECT_EQ(complaintAbout("nan.obj", "v nan 0 0\nv inf 0 0\nv 0 -inf 0\nf 1 2 3\n"),
              "none of its 1 triangles can be drawn: they have no finite position");
}

TEST(PoorMesh, TooFarAway_SaysSo) {
    EXPECT_EQ(complaintAbout("far.obj", "v 1e37 0 0\nv 0 1e37 0\nv 0 0 1e37\nf 1 2 3\n"),
              "none of its 1 triangles can be drawn: they have positions too large to draw "
              "(beyond 1e15)");
}

TEST(PoorMesh, SeveralReasons_AreAllNamed) {
    EXPECT_EQ(complaintAbout("poor.obj", "v nan 0 0\nv 0 0 0\nv 1 0 0\nf 1 2 3\nf 2 3 3\n"),
              "none of its 2 triangles can be drawn: they have no area or no finite position");
}

TEST(PoorMesh, TriangleWithoutArea_IsLeftOutAndReported) {
    const auto mesh = loaded("line.obj", std::string(squareObj).append("v 2 0 0\nf 1 2 5\n"));
    ASSERT_TRUE(mesh) << mesh.error().text();
    EXPECT_FALSE((*mesh)->remarks().empty());
}

TEST(PoorMesh, VanishinglySmall_IsKept) {
    const auto mesh = loaded("small.obj", "v 0 0 0\nv 1e-18 0 0\nv 0 1e-18 0\nf 1 2 3\n",
                             {.file = {}, .fitUnitBox = true});
    ASSERT_TRUE(mesh) << mesh.error().text();
    EXPECT_NEAR((*mesh)->view().vertices[0].normal.z, 1.0f, tolerance);
}

TEST(PoorMesh, NoFaces_SaysSo) {
    EXPECT_EQ(complaintAbout("points.ply", "ply\nformat ascii 1.0\nelement vertex 2\n"
                                           "property float x\nproperty float y\nproperty float z\n"
                                           "end_header\n0 0 0\n1 1 1\n"),
              "has points or lines but no faces");
}

TEST(PoorMesh, FacesBackToBack_HaveUnitNormals) {
    const auto mesh = loaded("both.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 3 2\n");
    ASSERT_TRUE(mesh) << mesh.error().text();
    for (const Vertex& vertex : (*mesh)->view().vertices) {
        EXPECT_NEAR(glm::length(vertex.normal), 1.0f, tolerance);
    }
}

} // namespace
} // namespace patina::tests::mesh_test
