// SPDX-License-Identifier: GPL-3.0-or-later
// How far the fitted light of an environment is from the settled one, for each shipped preset, and
// what it costs beside three directional lights.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

#include "benchmarks.h"
#include "gl/headless_context.h"
#include "material/preset_file.h"
#include "measure/error/flip.h"
#include "measure/error/picture_distance.h"
#include "primitive_meshes.h"
#include "render/renderer.h"
#include "scene/scene_file.h"
#include "stage.h"
#include "statistics.h"

namespace patina::benchmarks {
namespace {

constexpr glm::ivec2 size{128, 128};
constexpr int settledSamples = 1024;
constexpr double maxFlip = 0.06;
constexpr double maxMedianFlip = 0.03;
constexpr double maxMeanChange = 0.02;
constexpr double maxRatio = 1.5;
constexpr double maxTick = 0.03;
constexpr int warming = 3;
constexpr int rounds = 21;

const std::filesystem::path& presetFolder() {
    static const std::filesystem::path folder = PATINA_SOURCE_DIR "/presets";
    return folder;
}

std::vector<std::filesystem::path> presetFiles() {
    std::vector<std::filesystem::path> files;
    for (const auto& file : std::filesystem::recursive_directory_iterator(presetFolder())) {
        if (file.path().string().find(".patina.json") != std::string::npos) {
            files.push_back(file.path());
        }
    }
    std::ranges::sort(files);
    return files;
}

double meanOf(const std::vector<glm::dvec3>& colors) {
    double sum = 0.0;
    for (const glm::dvec3& color : colors) {
        sum += (color.r + color.g + color.b) / 3.0;
    }
    return sum / double(colors.size());
}

BlockValues studio() {
    BlockValues values;
    values.id = "studio";
    values.version = 1;
    return values;
}

/// How a preset looks in both ways.
struct Compared {
    double flip = 0.0;
    double change = 0.0; ///< of the picture's mean brightness
};

class FittedStage {
  public:
    FittedStage()
        : context_(gl::HeadlessContext::create().value()),
          catalog_(std::make_shared<const Catalog>(loadCatalog(standardBlockRoots()))),
          renderer_(Stage::rendererOf(catalog_)) {
        scene_ = readScene(presetFolder() / "three-lights.patina-scene.json", *catalog_)->scene;
        scene_.objects.resize(1);
        scene_.lights.clear();
        scene_.setPart("environment", studio());
    }

    std::optional<Compared> compare(const std::filesystem::path& preset) {
        const auto read = readPreset(preset, *catalog_);
        if (!read) {
            return std::nullopt;
        }
        scene_.objects.front().material = read->material;
        const auto settled = draw(0, settledSamples);
        const auto fitted = draw(1, 4);
        const std::vector<double> map = Flip(size, settled).differences(fitted);
        Compared result;
        for (const double each : map) {
            result.flip += each / double(map.size());
        }
        result.change = meanOf(fitted) / meanOf(settled) - 1.0;
        return result;
    }

  private:
    std::vector<glm::dvec3> draw(std::size_t level, int samples) {
        scene_.accuracy.choose(PictureChoice::Environment, level);
        View view;
        view.size = size;
        view.camera = scene_.camera;
        view.environmentSamples = samples;
        return displayColors(renderer_->capture(scene_, view, meshes_.source(), true).value());
    }

    std::unique_ptr<gl::HeadlessContext> context_;
    std::shared_ptr<const Catalog> catalog_;
    std::unique_ptr<Renderer> renderer_;
    Scene scene_;
    PrimitiveMeshes meshes_;
};

/// A frame of a ball under three lights, and under the fitted studio alone, of which it hides part
/// from itself, in turns; and what a tick of a slider of the material, or of the studio, adds to
/// the latter.
bool reportCosts() {
    Stage stage({512, 512});
    stage.scene.objects.front().mesh = "sphere";
    stage.use("cook-torrance");
    Scene lit = stage.scene;
    Scene fitted = stage.scene;
    fitted.lights.clear();
    fitted.setPart("environment", studio());
    fitted.occlusion = true;
    fitted.accuracy.choose(PictureChoice::Environment, 1);
    double& roughness =
        std::get<double>(fitted.objects.front().material.model.parameters["roughness"]);
    std::vector<double> ratios;
    double& intensity = std::get<double>(fitted.part("environment")->parameters["intensity"] = 1.0);
    std::vector<double> ticks;
    std::vector<double> skyTicks;
    for (int i = 0; i < rounds + warming; ++i) {
        const double underLights = stage.frameSeconds(lit);
        roughness = 0.2 + 0.01 * i;
        const double changed = stage.frameSeconds(fitted);
        const double same = stage.frameSeconds(fitted);
        intensity = 1.0 + 0.01 * i;
        const double underAnother = stage.frameSeconds(fitted);
        if (i >= warming) {
            ratios.push_back(same / underLights);
            ticks.push_back(changed - same);
            skyTicks.push_back(underAnother - same);
        }
    }
    const Spread ratio = spreadOf(ratios);
    const Spread tick = spreadOf(ticks);
    report("Fitted studio / three directional lights", text(ratio, 1.0, "times"),
           ratio.median <= maxRatio, fmt::format("<= {} times", maxRatio));
    report("Lobes after a slider's tick", text(tick, 1e3, "ms"), tick.median <= maxTick,
           "<= 30 ms");
    const Spread skyTick = spreadOf(skyTicks);
    report("Look-ups after a tick of the studio", text(skyTick, 1e3, "ms"),
           skyTick.median <= maxTick, "<= 30 ms");
    return ratio.median <= maxRatio && skyTick.median <= maxTick && tick.median <= maxTick;
}

} // namespace

bool fittedLight() {
    const bool kept = reportCosts();
    FittedStage stage;
    std::vector<double> flips;
    double worst = 0.0;
    double change = 0.0;
    for (const std::filesystem::path& file : presetFiles()) {
        const auto compared = stage.compare(file);
        if (!compared) {
            continue;
        }
        fmt::print("  {:<44} FLIP {:.4f}   mean {:+.1f} %\n",
                   std::filesystem::relative(file, presetFolder()).string(), compared->flip,
                   100.0 * compared->change);
        flips.push_back(compared->flip);
        worst = std::max(worst, compared->flip);
        change = std::max(change, std::abs(compared->change));
    }
    const double median = spreadOf(flips).median;
    report("Fitted light, FLIP, the worst preset", fmt::format("{:.3f}", worst), worst <= maxFlip,
           fmt::format("<= {}", maxFlip));
    report("Fitted light, FLIP, the median preset", fmt::format("{:.3f}", median),
           median <= maxMedianFlip, fmt::format("<= {}", maxMedianFlip));
    report("Fitted light, change of the mean", fmt::format("{:.1f} %", 100.0 * change),
           change <= maxMeanChange, "<= 2 %");
    return kept && worst <= maxFlip && median <= maxMedianFlip && change <= maxMeanChange;
}

} // namespace patina::benchmarks
