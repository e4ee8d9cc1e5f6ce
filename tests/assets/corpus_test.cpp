// SPDX-License-Identifier: GPL-3.0-or-later
// Every mesh of Debian's package assimp-testmodels, good and bad.
#include <algorithm>
#include <array>
#include <cctype>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <vector>

#include <gtest/gtest.h>

#include "mesh_files.h"

namespace patina::tests::corpus_test {
namespace {

namespace fs = std::filesystem;

bool isMesh(const fs::path& file) {
    static constexpr std::array formats{".obj", ".gltf", ".glb", ".ply", ".stl", ".fbx", ".dae"};
    std::string extension = file.extension().string();
    std::ranges::transform(extension, extension.begin(),
                           [](unsigned char c) { return std::tolower(c); });
    return std::ranges::find(formats, extension) != formats.end();
}

const fs::path folder = "/usr/share/assimp/models";

/// Debian and what is made of it have the package; there it must not be missing.
bool isDebian() {
    return fs::exists("/etc/debian_version");
}

std::vector<fs::path> corpus() {
    std::vector<fs::path> files;
    std::error_code absent;
    for (const auto& entry : fs::recursive_directory_iterator(folder, absent)) {
        if (entry.is_regular_file() && isMesh(entry.path())) {
            files.push_back(entry.path());
        }
    }
    std::ranges::sort(files);
    return files;
}

/// Neither a crash nor a time limit: something the file itself is to blame for.
bool blamesTheFile(const Error& error) {
    return !error.problem.empty() && error.problem.find("process") == std::string::npos &&
           error.problem.find("seconds") == std::string::npos;
}

TEST(AssimpTestModels, EveryFile_EndsInAMeshOrAClearMessage) {
    const std::vector<fs::path> files = corpus();
    if (files.empty() && !isDebian()) {
        GTEST_SKIP() << "there is no " << folder << ": this system has no package of test models";
    }
    ASSERT_GT(files.size(), 100u) << "the package assimp-testmodels is not installed";
    AssetClient client; // with the limits of 20 s and 2 GiB that the editor has
    int meshes = 0;
    double slowest = 0.0;
    for (const fs::path& file : files) {
        const auto begin = std::chrono::steady_clock::now();
        const auto mesh = client.loadMesh({file});
        const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
        slowest = std::max(slowest, took.count());
        meshes += mesh ? 1 : 0;
        if (!mesh) {
            std::printf("%s\n", mesh.error().text().c_str());
            EXPECT_TRUE(blamesTheFile(mesh.error()));
        }
    }
    std::printf("%zu files: %d meshes, %zu messages, slowest %.3f s\n", files.size(), meshes,
                files.size() - std::size_t(meshes), slowest);
    EXPECT_GT(meshes, 100);
}

} // namespace
} // namespace patina::tests::corpus_test
