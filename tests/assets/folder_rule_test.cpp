// SPDX-License-Identifier: GPL-3.0-or-later
// A mesh file pulls in nothing from outside its folder, whatever links and names it gives.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/stat.h>

#include "mesh_files.h"

namespace patina::tests::folder_rule_test {
namespace {

class MeshFolderRule : public testing::Test {
  protected:
    MeshFolderRule() {
        std::filesystem::create_directory(folder_ / "mesh");
        writeFile(folder_ / "secret.obj", squareObj);
    }

    void link(const std::filesystem::path& target, const std::string& name) const {
        std::filesystem::create_symlink(target, folder_ / ("mesh/" + name));
    }
    LoadedMesh load(const std::string& name, const std::string& content) {
        writeFile(folder_ / ("mesh/" + name), content);
        return client_.loadMesh({folder_ / ("mesh/" + name)});
    }
    /// A scene of LightWave with the square in the folder and another mesh.
    LoadedMesh loadSceneWith(const std::string& other) {
        writeFile(folder_ / "mesh/own.obj", squareObj);
        return load("a.lws",
                    "LWSC\n3\n\nLoadObjectLayer 1 own.obj\n\nLoadObjectLayer 1 " + other + "\n");
    }
    /// A triangle in a buffer beside it.
    static std::string gltfWith(const std::string& buffer) {
        const nlohmann::json gltf{
            {"asset", {{"version", "2.0"}}},
            {"scene", 0},
            {"scenes", {{{"nodes", {0}}}}},
            {"nodes", {{{"mesh", 0}}}},
            {"meshes", {{{"primitives", {{{"attributes", {{"POSITION", 0}}}}}}}}},
            {"accessors",
             {{{"bufferView", 0},
               {"componentType", 5126},
               {"count", 3},
               {"type", "VEC3"},
               {"min", {0, 0, 0}},
               {"max", {1, 1, 0}}}}},
            {"bufferViews", {{{"buffer", 0}, {"byteOffset", 0}, {"byteLength", 36}}}},
            {"buffers", {{{"uri", buffer}, {"byteLength", 36}}}}};
        return gltf.dump();
    }
    static std::string triangle() {
        const float corners[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
        return {reinterpret_cast<const char*>(corners), sizeof corners};
    }

    TemporaryFolder folder_;
    AssetClient client_;
};

TEST_F(MeshFolderRule, GltfBufferInTheFolder_IsRead) {
    writeFile(folder_ / "mesh/a.bin", triangle());
    const LoadedMesh mesh = load("a.gltf", gltfWith("a.bin"));
    ASSERT_TRUE(mesh) << mesh.error().text();
    EXPECT_EQ((*mesh)->view().indices.size(), 3u);
}

TEST_F(MeshFolderRule, GltfBufferBehindALinkInTheFolder_IsRead) {
    writeFile(folder_ / "mesh/b.bin", triangle());
    link("b.bin", "a.bin");
    const LoadedMesh mesh = load("a.gltf", gltfWith("a.bin"));
    EXPECT_TRUE(mesh) << mesh.error().text();
}

TEST_F(MeshFolderRule, GltfBufferBehindALinkOutOfIt_IsRefused) {
    writeFile(folder_ / "secret.bin", triangle());
    link("../secret.bin", "a.bin");
    const LoadedMesh mesh = load("a.gltf", gltfWith("a.bin"));
    ASSERT_FALSE(mesh);
    EXPECT_EQ(mesh.error().problem, "its buffer \"a.bin\" lies outside its folder and is not read");
}

TEST_F(MeshFolderRule, GltfBufferOutside_IsReadWhenEveryLinkIsAllowed) {
    writeFile(folder_ / "secret.bin", triangle());
    for (const std::string& buffer :
         {std::string("../secret.bin"), std::string("%2e%2e/secret.bin"),
          (folder_ / "secret.bin").string()}) {
        client_.setRights({});
        const LoadedMesh refused = load("a.gltf", gltfWith(buffer));
        ASSERT_FALSE(refused) << buffer;
        EXPECT_EQ(refused.error().problem,
                  "its buffer \"" + buffer + "\" lies outside its folder and is not read");
        client_.setRights({.allowsEveryLink = true});
        const LoadedMesh mesh = load("a.gltf", gltfWith(buffer));
        ASSERT_TRUE(mesh) << mesh.error().text();
        EXPECT_EQ((*mesh)->view().indices.size(), 3u);
        EXPECT_EQ(client_.refusedLinks(folder_ / "mesh/a.gltf"), std::vector<std::string>());
    }
}

TEST_F(MeshFolderRule, RefusedLink_IsNamedByWhereItLiesAndReadWhenThatIsAllowed) {
    writeFile(folder_ / "secret.bin", triangle());
    link("../secret.bin", "a.bin");
    ASSERT_FALSE(load("a.gltf", gltfWith("a.bin")));
    const std::vector<std::string> refused = client_.refusedLinks(folder_ / "mesh/a.gltf");
    ASSERT_EQ(refused, std::vector{std::filesystem::canonical(folder_ / "secret.bin").string()});
    client_.setRights({.links = {refused.begin(), refused.end()}});
    const LoadedMesh mesh = load("a.gltf", gltfWith("a.bin"));
    EXPECT_TRUE(mesh) << mesh.error().text();
}

TEST_F(MeshFolderRule, LinkThatNowLeadsToAnotherFile_IsRefusedAgain) {
    writeFile(folder_ / "secret.bin", triangle());
    writeFile(folder_ / "other.bin", triangle());
    link("../secret.bin", "a.bin");
    client_.setRights({.links = {std::filesystem::canonical(folder_ / "secret.bin").string()}});
    ASSERT_TRUE(load("a.gltf", gltfWith("a.bin")));
    std::filesystem::remove(folder_ / "mesh/a.bin");
    link("../other.bin", "a.bin");
    EXPECT_FALSE(load("a.gltf", gltfWith("a.bin")));
}

TEST_F(MeshFolderRule, AllowedPipe_IsStillRefusedWithoutWaiting) {
    ASSERT_EQ(::mkfifo((folder_ / "pipe.bin").c_str(), 0600), 0);
    client_.setRights({.allowsEveryLink = true});
    EXPECT_FALSE(load("a.gltf", gltfWith("../pipe.bin")));
}

TEST_F(MeshFolderRule, GltfBufferThatIsAPipe_IsRefusedWithoutWaiting) {
    ASSERT_EQ(::mkfifo((folder_ / "mesh/a.bin").c_str(), 0600), 0);
    EXPECT_FALSE(load("a.gltf", gltfWith("a.bin")));
}

TEST_F(MeshFolderRule, MeshThatIsALinkItself_IsRead) {
    link("../secret.obj", "a.obj");
    const LoadedMesh mesh = client_.loadMesh({folder_ / "mesh/a.obj"});
    EXPECT_TRUE(mesh) << mesh.error().text();
}

TEST_F(MeshFolderRule, SceneOfMeshesInTheFolder_IsRead) {
    writeFile(folder_ / "mesh/other.obj", squareObj);
    const LoadedMesh mesh = loadSceneWith("other.obj");
    ASSERT_TRUE(mesh) << mesh.error().text();
    EXPECT_EQ((*mesh)->view().indices.size(), 12u);
    EXPECT_EQ((*mesh)->remarks(), "");
}

TEST_F(MeshFolderRule, MeshOfASceneOutside_IsLeftOutWithARemark) {
    const LoadedMesh mesh = loadSceneWith("../secret.obj");
    ASSERT_TRUE(mesh) << mesh.error().text();
    EXPECT_EQ((*mesh)->view().indices.size(), 6u);
    EXPECT_NE((*mesh)->remarks().find("secret.obj\" lies outside its folder and is not read"),
              std::string::npos)
        << (*mesh)->remarks();
}

TEST_F(MeshFolderRule, MeshOfASceneBehindALink_IsLeftOutWithARemark) {
    link("../secret.obj", "linked.obj");
    const LoadedMesh mesh = loadSceneWith("linked.obj");
    ASSERT_TRUE(mesh) << mesh.error().text();
    EXPECT_EQ((*mesh)->view().indices.size(), 6u);
    EXPECT_NE((*mesh)->remarks().find("linked.obj\" lies outside"), std::string::npos)
        << (*mesh)->remarks();
}

TEST_F(MeshFolderRule, MeshOfASceneOutside_IsReadWhenThatIsAllowed) {
    client_.setRights({.allowsEveryLink = true});
    const LoadedMesh mesh = loadSceneWith("../secret.obj");
    ASSERT_TRUE(mesh) << mesh.error().text();
    EXPECT_EQ((*mesh)->view().indices.size(), 12u);
    EXPECT_EQ((*mesh)->remarks(), "");
}

/// They would change nothing of the mesh, so nobody is asked about them.
TEST_F(MeshFolderRule, MaterialsOutside_AreNoLinkThatIsMissed) {
    writeFile(folder_ / "secret.mtl", "newmtl a\nKd 1 0 0\n");
    const LoadedMesh mesh = load("a.obj", "mtllib ../secret.mtl\nv 0 0 0\nv 1 0 0\nv 2 1 0\n"
                                          "v 1 2 0\nv 0 1 0\nusemtl a\nf 1 2 3 4 5\n");
    ASSERT_TRUE(mesh) << mesh.error().text();
    EXPECT_EQ((*mesh)->remarks(), "");
    EXPECT_EQ(client_.refusedLinks(folder_ / "mesh/a.obj"), std::vector<std::string>());
}

TEST_F(MeshFolderRule, FileThatAnX3dSceneTakesInFromOutside_IsReadWhenThatIsAllowed) {
    const auto x3d = [](const std::string& content) {
        return "<?xml version=\"1.0\" encoding=\"UTF-8\"?><X3D version=\"3.0\"><Scene>" + content +
               "</Scene></X3D>";
    };
    const std::string triangles =
        "<Shape><IndexedTriangleSet index=\"0 1 2\"><Coordinate point=\"0 0 0 1 0 0 0 1 0\"/>"
        "</IndexedTriangleSet></Shape>";
    writeFile(folder_ / "secret.x3d", x3d(triangles));
    link("../secret.x3d", "linked.x3d");
    const LoadedMesh mesh = load("a.x3d", x3d(triangles + "<Inline url=\"linked.x3d\"/>"));
    ASSERT_FALSE(mesh); // the reader takes all or nothing
    EXPECT_NE(mesh.error().text().find("linked.x3d"), std::string::npos) << mesh.error().text();
    client_.setRights({.allowsEveryLink = true});
    const LoadedMesh allowed = client_.loadMesh({folder_ / "mesh/a.x3d"});
    ASSERT_TRUE(allowed) << allowed.error().text();
    EXPECT_EQ((*allowed)->view().indices.size(), 6u);
}

/// Assimp waited for it for ever.
TEST_F(MeshFolderRule, MaterialsThatAreAPipe_DoNotHoldUpAMesh) {
    ASSERT_EQ(::mkfifo((folder_ / "mesh/a.mtl").c_str(), 0600), 0);
    const LoadedMesh mesh =
        load("a.obj", "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 2 1 0\nv 1 2 0\nv 0 1 0\nf 1 2 3 4 5\n");
    EXPECT_TRUE(mesh) << mesh.error().text();
}

TEST_F(MeshFolderRule, SparseMeshOfTenGigabytes_IsRefusedBySize) {
    writeFile(folder_ / "mesh/a.obj", squareObj);
    std::filesystem::resize_file(folder_ / "mesh/a.obj", std::uintmax_t(10) << 30);
    const LoadedMesh mesh = client_.loadMesh({folder_ / "mesh/a.obj"});
    ASSERT_FALSE(mesh);
    EXPECT_EQ(mesh.error().problem, "is larger than 1 GiB");
}

/// Whoever followed the list waited for the pipe.
TEST_F(MeshFolderRule, ListOfMovies_IsNotFollowed) {
    ASSERT_EQ(::mkfifo((folder_ / "secret.ts").c_str(), 0600), 0);
    writeFile(folder_ / "mesh/a.avi", "#EXTM3U\n#EXT-X-TARGETDURATION:1\n#EXTINF:1,\n"
                                      "../secret.ts\n#EXT-X-ENDLIST\n");
    const auto image = client_.loadImage(folder_ / "mesh/a.avi");
    ASSERT_FALSE(image);
    EXPECT_EQ(image.error().problem, "is a movie, not an image");
}

TEST_F(MeshFolderRule, Device_IsRefused) {
    EXPECT_EQ(client_.loadMesh({"/dev/ptmx"}).error().problem, "is a device");
    EXPECT_EQ(client_.loadImage("/dev/zero").error().problem, "is a device");
}

} // namespace
} // namespace patina::tests::folder_rule_test
