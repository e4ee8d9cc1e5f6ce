// SPDX-License-Identifier: GPL-3.0-or-later
// Normals on their way to the GPU, where nothing looks for numbers that are none.
#include "render/gpu/valid_normals.h"

#include <limits>

#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include "gpu/gpu_fixture.h"
#include "render/gpu/gpu_mesh.h"

namespace patina::valid_normals_test {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

glm::vec3 validNormal(const glm::vec3& normal) {
    Vertex vertex;
    vertex.normal = normal;
    return withValidNormals(std::span(&vertex, 1)).front().normal;
}

TEST(ValidNormals, UnitAndZeroOnes_StayAsTheyAre) {
    for (const glm::vec3& normal :
         {glm::vec3(0.6f, 0.0f, -0.8f), glm::vec3(0.0f, -0.99f, 0.0f), glm::vec3(0.0f)}) {
        EXPECT_EQ(validNormal(normal), normal);
    }
}

TEST(ValidNormals, ShortAndLongOnes_BecomeUnit) {
    EXPECT_EQ(validNormal({0.0f, 0.0f, 1e-40f}), glm::vec3(0.0f, 0.0f, 1.0f));
    EXPECT_EQ(validNormal({0.0f, -3.0f, 0.0f}), glm::vec3(0.0f, -1.0f, 0.0f));
    EXPECT_EQ(validNormal({3e38f, 0.0f, 0.0f}), glm::vec3(1.0f, 0.0f, 0.0f));
}

TEST(ValidNormals, ThoseWithoutADirection_BecomeZero) {
    for (const float wrong : {nan, infinity, -infinity}) {
        EXPECT_EQ(validNormal({wrong, 0.0f, 1.0f}), glm::vec3(0.0f)) << wrong;
    }
}

TEST(ValidNormals, OnlyTheNormal_IsChanged) {
    Vertex vertex;
    vertex.position = {1.0f, 2.0f, 3.0f};
    vertex.normal = glm::vec3(nan);
    vertex.uv = {0.25f, 0.75f};
    Vertex expected = vertex;
    expected.normal = glm::vec3(0.0f);
    EXPECT_FALSE(haveValidNormals(std::span(&vertex, 1)));
    EXPECT_EQ(withValidNormals(std::span(&vertex, 1)).front(), expected);
}

TEST(ValidNormals, OfBuiltInMeshes_NeedNoChange) {
    for (const std::string& name : primitiveNames()) {
        EXPECT_TRUE(haveValidNormals(primitive(name)->vertices)) << name;
    }
}

class UploadedMesh : public GpuTest {};

/// Slices that end within a vertex, in the middle of its normal too.
TEST_F(UploadedMesh, InSlicesOfAnySize_HasValidNormals) {
    Mesh mesh;
    for (const glm::vec3& normal : {glm::vec3(0.0f, infinity, 1.0f), glm::vec3(0.6f, 0.0f, 0.8f),
                                    glm::vec3(1.0f, 1.0f, nan)}) {
        mesh.vertices.emplace_back().normal = normal;
    }
    mesh.indices = {0, 1, 2};
    const std::vector<Vertex> expected = withValidNormals(mesh.vertices);
    const std::size_t bytes = mesh.view().vertices.size_bytes();
    for (const std::size_t slice : {std::size_t(64), std::size_t(113), bytes}) {
        GpuMesh uploaded(mesh.view());
        for (std::size_t sent = 0; sent < bytes; sent += slice) {
            uploaded.upload(mesh.view(), slice);
        }
        std::vector<Vertex> found(mesh.vertices.size()); // the vertices' buffer is still bound
        glGetBufferSubData(GL_COPY_WRITE_BUFFER, 0, static_cast<GLsizeiptr>(bytes), found.data());
        EXPECT_EQ(found, expected) << slice;
    }
}

} // namespace
} // namespace patina::valid_normals_test
