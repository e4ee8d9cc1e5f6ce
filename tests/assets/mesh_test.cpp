// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "assets/asset_client.h"
#include "temporary_folder.h"

namespace patina {
namespace {

using test::TemporaryFolder;

constexpr const char* square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";

TEST(MeshFile, SquareObj_BecomesTwoTrianglesWithJoinedVertices) {
    const TemporaryFolder folder;
    AssetClient client;
    const auto mesh = client.loadMesh({folder.write("square.obj", square)});
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

} // namespace
} // namespace patina
