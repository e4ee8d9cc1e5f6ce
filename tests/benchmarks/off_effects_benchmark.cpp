// SPDX-License-Identifier: GPL-3.0-or-later
// What effects cost that are there and not in the scene: beside shaders without their files.
#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <utility>

#include <epoxy/gl.h>

#include "benchmarks.h"
#include "cpu_clock.h"
#include "shading/effects/effect_set.h"
#include "shading/effects/surface_program.h"
#include "shading/program/program_source.h"
#include "stage.h"
#include "statistics.h"

namespace patina::benchmarks {
namespace {

namespace fs = std::filesystem;

constexpr int pairs = 10;
constexpr int roundsOfPair = 9;
constexpr double maxRatio = 1.01;

using SharedCatalog = std::shared_ptr<const Catalog>;

using Ids = std::set<std::pair<std::string, std::string>>; ///< kind, id

/// The blocks that a scene names.
Ids namedBlocks(const Scene& scene) {
    const Material& material = scene.objects.front().material;
    Ids named{{"models", material.model.id}};
    for (const auto& [kind, part] : material.parts) {
        named.insert({kind, part.id});
    }
    for (const Light& light : scene.lights) {
        named.insert({"lights", light.block.id});
        if (light.part(kinds::shadows)) {
            named.insert({"shadows", light.part(kinds::shadows)->id});
        }
    }
    for (const auto& [kind, block] : scene.parts) {
        named.insert({kind, block.id});
    }
    return named;
}

/// The shipped shaders with no other blocks than those that a scene names.
SharedCatalog needed(const Scene& scene, const Catalog& shipped, const fs::path& folder) {
    fs::copy(shipped.roots.front().folder, folder, fs::copy_options::recursive);
    const Ids named = namedBlocks(scene);
    for (const Block& block : shipped.blocks) {
        if (!named.contains({block.kind, block.id})) {
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

/// The surface's program as it is made from one catalogue and from another.
bool isSameText(const Scene& scene, const Catalog& one, const Catalog& other) {
    const Material& material = scene.objects.front().material;
    return surfaceProgram(effectSet(material, scene, one), one)->hash() ==
           surfaceProgram(effectSet(material, scene, other), other)->hash();
}

/// A frame with the first catalogue / with the second. Where in memory the targets of a renderer
/// lie changes its frames by more than the target allows: each pair of renderers is made anew, the
/// first of them before and after the other in turn, and its frames are as often the first of a
/// round.
Spread frameRatio(Stage& stage, const SharedCatalog& first, const SharedCatalog& second) {
    std::vector<double> ratios;
    for (int pair = 0; pair < pairs; ++pair) {
        const bool isReversed = pair % 2 == 1;
        const std::unique_ptr<Renderer> one = Stage::rendererOf(isReversed ? second : first);
        seconds(stage, *one); // makes its programs and targets
        const std::unique_ptr<Renderer> other = Stage::rendererOf(isReversed ? first : second);
        seconds(stage, *other);
        for (int round = 0; round < roundsOfPair; ++round) {
            const double before = seconds(stage, *one);
            const double between = seconds(stage, *other) + seconds(stage, *other);
            const double ratio = (before + seconds(stage, *one)) / between;
            ratios.push_back(isReversed ? 1.0 / ratio : ratio);
        }
    }
    return spreadOf(ratios);
}

} // namespace

bool offEffects() {
    Stage stage({640, 480});
    stage.use("phong");
    const tests::TemporaryFolder folder;
    const SharedCatalog used = needed(stage.scene, stage.catalog(), folder / "shaders");
    const auto all = std::make_shared<const Catalog>(stage.catalog());
    const std::string blocks =
        fmt::format("{} blocks there / {} that are used", all->blocks.size(), used->blocks.size());
    const bool isSame = isSameText(stage.scene, *all, *used);
    report(blocks + ": program", isSame ? "the same text" : "another text", isSame, "the same");
    const Spread ratio = frameRatio(stage, all, used);
    const bool kept = ratio.median <= maxRatio;
    report(blocks + ": frame", text(ratio, 1.0, ""), kept, "<= 1.01");
    report("the same blocks on both sides: frame", text(frameRatio(stage, all, all), 1.0, ""), true,
           "what is noise");
    return isSame && kept;
}

} // namespace patina::benchmarks
