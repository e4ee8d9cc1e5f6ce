// SPDX-License-Identifier: GPL-3.0-or-later
// Files cut short, emptied and filled with noise: always a mesh or a message about the file.
#include <filesystem>
#include <random>

#include <gtest/gtest.h>

#include "mesh_files.h"

namespace patina::tests::damaged_file_test {
namespace {

constexpr const char* models = "/usr/share/assimp/models/";

/// One whole file of every format.
struct Sample {
    const char* name;
    const char* file;
};
void PrintTo(const Sample& sample, std::ostream* stream) { *stream << sample.name; }

class DamagedMesh : public testing::TestWithParam<Sample> {
  protected:
    void SetUp() override {
        content_ = readFile(models + std::string(GetParam().file));
        ASSERT_FALSE(content_.empty()) << "the package assimp-testmodels is not installed";
    }

    /// Loads the content under the sample's extension; the process must survive or be replaced.
    void expectMeshOrMessage(const std::string& content) {
        const std::filesystem::path file =
            folder_ / ("sample" + std::filesystem::path(GetParam().file).extension().string());
        writeFile(file, content);
        const auto mesh = client_.loadMesh({file});
        if (!mesh) {
            EXPECT_EQ(mesh.error().file, file.string());
            EXPECT_EQ(mesh.error().problem.find("seconds"), std::string::npos)
                << mesh.error().text();
        }
    }

    std::string content_;
    TemporaryFolder folder_;
    AssetClient client_;
};

TEST_P(DamagedMesh, CutShort_EndsInAMeshOrAMessage) {
    for (int part = 1; part < 20; ++part) {
        expectMeshOrMessage(content_.substr(0, content_.size() * std::size_t(part) / 20));
    }
}

TEST_P(DamagedMesh, WithWrongBytes_EndsInAMeshOrAMessage) {
    std::mt19937 random(7);
    for (int round = 0; round < 30; ++round) {
        std::string damaged = content_;
        for (int i = 0; i < 10; ++i) {
            damaged[random() % damaged.size()] = static_cast<char>(random() % 256);
        }
        expectMeshOrMessage(damaged);
    }
}

TEST_P(DamagedMesh, OfNoise_EndsInAMessage) {
    std::mt19937 random(11);
    std::string noise(20000, '\0');
    for (char& byte : noise) {
        byte = static_cast<char>(random() % 256);
    }
    expectMeshOrMessage(noise);
}

TEST_P(DamagedMesh, Empty_EndsInAMessage) { expectMeshOrMessage(""); }

TEST_P(DamagedMesh, AfterAllThat_GoodOnesStillLoad) {
    expectMeshOrMessage(content_.substr(0, content_.size() / 2));
    writeFile(folder_ / "square.obj", squareObj);
    const auto mesh = client_.loadMesh({folder_ / "square.obj"});
    EXPECT_TRUE(mesh) << mesh.error().text();
}

INSTANTIATE_TEST_SUITE_P(
    OfEveryFormat, DamagedMesh,
    testing::Values(Sample{"obj", "OBJ/spider.obj"}, Sample{"ply", "PLY/cube_binary.ply"},
                    Sample{"stl", "STL/Spider_binary.stl"}, Sample{"fbx", "FBX/spider.fbx"},
                    Sample{"dae", "Collada/duck.dae"},
                    Sample{"gltf", "glTF2/BoxTextured-glTF-Embedded/BoxTextured.gltf"},
                    Sample{"glb", "glTF2/BoxTextured-glTF-Binary/BoxTextured.glb"}),
    [](const auto& information) { return std::string(information.param.name); });

} // namespace
} // namespace patina::tests::damaged_file_test
