// SPDX-License-Identifier: GPL-3.0-or-later
// What a sweep of a shipped preset takes, and whether the same sweep gives the same front again.
#include <algorithm>
#include <cctype>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "benchmarks.h"
#include "gl/headless_context.h"
#include "material/preset_file.h"
#include "measure/cost/cost_sweep.h"
#include "primitive_meshes.h"
#include "scene/scene_file.h"
#include "statistics.h"
#include "support/front_share.h"
#include "support/program.h"

namespace patina::benchmarks {
namespace {

using Clock = std::chrono::steady_clock;

constexpr glm::ivec2 sizeOfTime{512, 512};
constexpr glm::ivec2 sizeOfFronts{128, 128};
constexpr double secondsOfFronts = 10.0;
constexpr double longestSeconds = 60.0;
constexpr std::size_t timedPresets = 3;
constexpr double minShare = 0.95;
constexpr const char* manyLevels = "many-levels"; ///< of the user's folder that this writes

const std::filesystem::path& presetFolder() {
    static const std::filesystem::path folder = PATINA_SOURCE_DIR "/presets";
    return folder;
}

/// A shipped preset under three lights.
struct Shipped {
    std::string name;
    Scene scene;
    std::size_t levels = 0; ///< that are not exact, of all choices
};

std::size_t levelsOf(const Scene& scene, const Catalog& catalog) {
    std::size_t levels = 0;
    for (const Choice& choice : materialChoices(scene, 0, catalog)) {
        levels += choice.levels.size() - 1;
    }
    return levels;
}

std::vector<Shipped> shippedPresets(const Catalog& catalog) {
    const auto stage = readScene(presetFolder() / "default.patina-scene.json", catalog);
    std::vector<Shipped> all;
    for (const auto& file : std::filesystem::recursive_directory_iterator(presetFolder())) {
        const std::filesystem::path path = file.path();
        if (!stage || path.string().find(".patina.json") == std::string::npos) {
            continue;
        }
        if (const auto preset = readPreset(path, catalog)) {
            Shipped shipped{std::filesystem::relative(path, presetFolder()).string(), stage->scene,
                            0};
            shipped.scene.objects.front().material = preset->material;
            shipped.levels = levelsOf(shipped.scene, catalog);
            all.push_back(std::move(shipped));
        }
    }
    std::ranges::sort(all, {}, &Shipped::name);
    return all;
}

/// The scene with a part of each kind, of which it takes the block that brings most levels.
void addParts(Scene& scene, const Catalog& catalog) {
    for (const char* kind : {"specular", "fresnel"}) {
        Scene best = scene;
        for (const Block* block : catalog.ofKind(kind)) {
            Scene tried = scene;
            tried.objects.front().material.parts[kind] =
                BlockValues{block->id, block->version, defaultValues(*block)};
            if (levelsOf(tried, catalog) > levelsOf(best, catalog)) {
                best = std::move(tried);
            }
        }
        scene = std::move(best);
    }
}

/// Returns the material with the largest number of levels that can be put together.
Shipped richest(const Catalog& catalog) {
    Shipped best;
    for (const Block* model : catalog.ofKind("models")) {
        if (model->id == manyLevels) {
            continue;
        }
        Scene scene = readScene(presetFolder() / "default.patina-scene.json", catalog)->scene;
        scene.objects.front().material = defaultMaterial(*model);
        addParts(scene, catalog);
        if (const std::size_t levels = levelsOf(scene, catalog); levels > best.levels) {
            best = {model->label + " with all parts", std::move(scene), levels};
        }
    }
    return best;
}

/// A model with four choices of three cheaper levels each, of which all save some work.
void writeManyLevels(const std::filesystem::path& folder) {
    std::string choices;
    std::string terms;
    for (const char* name : {"first", "second", "third", "fourth"}) {
        std::string upper = name;
        std::ranges::transform(upper, upper.begin(), [](unsigned char letter) {
            return static_cast<char>(std::toupper(letter));
        });
        choices += fmt::format(
            R"({}{{"id": "{}", "label": "{}", "doc": "d", "values": [
  {{"id": "all", "label": "All", "doc": "d", "exact": true}},
  {{"id": "half", "label": "Half", "doc": "d"}}, {{"id": "some", "label": "Some", "doc": "d"}},
  {{"id": "few", "label": "Few", "doc": "d"}}]}})",
            choices.empty() ? "" : ",\n", name, name);
        terms += fmt::format("    int {0}Count = p.{0} == MANY_LEVELS_{1}_FEW ? 3 : p.{0} == "
                             "MANY_LEVELS_{1}_SOME ? 6 : p.{0} == MANY_LEVELS_{1}_HALF ? 12 : 24;\n"
                             "    for (int i = 0; i < {0}Count; ++i) {{\n"
                             "        sum += sin(d.nl + float(i) * sum);\n    }}\n"
                             "    value += 0.01 / float({0}Count);\n",
                             name, upper);
    }
    std::filesystem::create_directories(folder / "models");
    std::ofstream(folder / "models" / "many-levels.json")
        << R"({"id": "many-levels", "version": 1, "label": "Many levels", "summary": "s",
"applications": "a", "source": "a benchmark", "doc": "d", "parameters": [], "claims": [],
"accuracy": [)"
        << choices << "]}";
    std::ofstream(folder / "models" / "many-levels.glsl")
        << "// SPDX-License-"
           "Identifier: MIT-0\n#include \"lib/directions.glsl\"\n\n"
           "vec3 manyLevels(Directions d, ManyLevels p) {\n    float sum = 0.0;\n"
           "    float value = 0.5;\n"
        << terms << "    return vec3(d.nl * value + 1e-12 * sum);\n}\n";
}

Shipped withManyLevels(const Catalog& catalog) {
    Shipped made{"a model with four choices",
                 readScene(presetFolder() / "default.patina-scene.json", catalog)->scene, 0};
    made.scene.objects.front().material = defaultMaterial(*catalog.find("models", manyLevels));
    made.levels = levelsOf(made.scene, catalog);
    return made;
}

struct Timed {
    CostChart chart;
    double firstSeconds = 0.0; ///< until a point was there
    double seconds = 0.0;
};

Timed swept(const Shipped& shipped, const std::shared_ptr<const Catalog>& catalog,
            const CostSweep::Options& options) {
    PrimitiveMeshes meshes;
    const MeshSource source = meshes.source();
    const Clock::time_point began = Clock::now();
    const auto spent = [began] {
        return std::chrono::duration<double>(Clock::now() - began).count();
    };
    auto sweep =
        CostSweep::create({shipped.scene, 0, shipped.scene.camera, source, catalog}, options);
    if (!sweep) {
        fmt::print(stderr, "{}: {}\n", shipped.name, sweep.error().text());
        std::exit(2);
    }
    Timed timed;
    while (!(*sweep)->finished()) {
        (*sweep)->step(std::chrono::milliseconds(100));
        if (timed.firstSeconds == 0.0 && !(*sweep)->chart().points.empty()) {
            timed.firstSeconds = spent();
        }
    }
    timed.seconds = spent();
    timed.chart = (*sweep)->chart();
    return timed;
}

} // namespace

bool sweepTime() {
    const auto context = gl::HeadlessContext::create().value();
    const tests::TemporaryFolder folder;
    writeManyLevels(folder.path());
    std::vector<BlockRoot> roots = standardBlockRoots();
    roots.push_back({folder.path(), false});
    const auto catalog = std::make_shared<const Catalog>(loadCatalog(roots));
    std::vector<Shipped> all = shippedPresets(*catalog);
    std::ranges::stable_sort(all, std::ranges::greater(), &Shipped::levels);
    all.resize(std::min(all.size(), timedPresets));
    all.push_back(richest(*catalog));
    all.push_back(withManyLevels(*catalog));
    CostSweep::Options options;
    options.size = sizeOfTime;
    bool kept = true;
    for (const Shipped& shipped : all) {
        const Timed timed = swept(shipped, catalog, options);
        const bool isKept = timed.seconds <= longestSeconds;
        report(fmt::format("Sweep of {} levels, {}", shipped.levels, shipped.name),
               fmt::format("{:.1f} s, {} points, the first after {:.1f} s", timed.seconds,
                           timed.chart.points.size(), timed.firstSeconds),
               isKept, "<= 60 s");
        kept = kept && isKept;
    }
    return kept;
}

bool frontTwice() {
    const auto context = gl::HeadlessContext::create().value();
    const auto catalog = std::make_shared<const Catalog>(loadCatalog(standardBlockRoots()));
    CostSweep::Options options;
    options.size = sizeOfFronts;
    options.seconds = secondsOfFronts;
    options.combinations = false; // which ones there is time for is a matter of time
    tests::FrontShare whole;
    for (const Shipped& shipped : shippedPresets(*catalog)) {
        if (shipped.levels == 0) {
            continue;
        }
        const CostChart first = swept(shipped, catalog, options).chart;
        const CostChart second = swept(shipped, catalog, options).chart;
        const tests::FrontShare share = tests::frontShare(first, second);
        report(fmt::format("Front twice, {}", shipped.name),
               fmt::format("{} of {} points", share.same, share.points), true, "");
        whole += share;
    }
    const bool kept = whole.share() >= minShare;
    report("Front twice, all presets",
           fmt::format("{:.1f} % of {} points", 100.0 * whole.share(), whole.points), kept,
           ">= 95 %");
    return kept;
}

} // namespace patina::benchmarks
