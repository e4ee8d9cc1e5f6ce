// SPDX-License-Identifier: GPL-3.0-or-later
// What effects cost that are there and not in the scene: beside shaders without their files.
#include <filesystem>
#include <memory>
#include <string>

#include <epoxy/gl.h>

#include "benchmarks.h"
#include "cpu_clock.h"
#include "stage.h"
#include "statistics.h"

namespace patina::benchmarks {
namespace {

namespace fs = std::filesystem;

constexpr int rounds = 41;
constexpr double mostRatio = 1.01;

/// The shipped shaders with no other blocks than a scene has: its model and its lights.
std::shared_ptr<const Catalog> needed(const Scene& scene, const Catalog& shipped,
                                      const fs::path& folder) {
    fs::copy(shipped.roots.front().folder, folder, fs::copy_options::recursive);
    for (const Block& block : shipped.blocks) {
        const bool isModel = block.kind == "models" &&
                             block.id == scene.objects.front().material.model.id;
        const bool isLight = block.kind == "lights" &&
                             std::ranges::any_of(scene.lights, [&](const Light& light) {
                                 return light.block.id == block.id;
                             });
        if (!isModel && !isLight) {
            fs::remove(folder / block.kind / (block.id + ".json"));
            fs::remove(folder / block.kind / (block.id + ".glsl"));
        }
    }
    return std::make_shared<const Catalog>(loadCatalog(std::array{BlockRoot{folder, true}}));
}

double seconds(Stage& stage, Renderer& renderer) {
    const double began = workSeconds();
    stage.drawWith(renderer);
    glFinish();
    return workSeconds() - began;
}

} // namespace

bool offEffects() {
    Stage stage({640, 480});
    stage.use("phong");
    const tests::TemporaryFolder folder;
    const auto used = needed(stage.scene, stage.catalog(), folder / "shaders");
    const auto all = std::make_shared<const Catalog>(stage.catalog());
    std::unique_ptr<Renderer> withAll = Stage::rendererOf(all);
    std::unique_ptr<Renderer> withFew = Stage::rendererOf(used);
    seconds(stage, *withAll); // these make the programs
    seconds(stage, *withFew);
    std::vector<double> ratios;
    for (int round = 0; round < rounds; ++round) {
        const double first = seconds(stage, *withAll); // each is first as often as the other
        const double few = seconds(stage, *withFew) + seconds(stage, *withFew);
        ratios.push_back((first + seconds(stage, *withAll)) / few);
    }
    const Spread ratio = spreadOf(ratios);
    const bool kept = ratio.median <= mostRatio;
    report(fmt::format("{} blocks there / {} that are used", all->blocks.size(),
                       used->blocks.size()),
           text(ratio, 1.0, ""), kept, "<= 1.01");
    return kept;
}

} // namespace patina::benchmarks
