// SPDX-License-Identifier: GPL-3.0-or-later
// What putting a program together from blocks costs beside one that is written by hand for the same
// job.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "assembled_program.h"
#include "benchmarks.h"
#include "material/block_values.h"
#include "minimal_program.h"
#include "statistics.h"

namespace patina::benchmarks {
namespace {

constexpr int rounds = 21;
constexpr double mostRatio = 1.05;
constexpr double mostMedian = 1.02;
constexpr double mostDifference = 1.0 / 255.0;

/// Those with a file in minimal/.
constexpr std::array models{"lambert",         "phong",      "blinn-phong", "gaussian",
                            "schlick",         "minnaert",   "oren-nayar",  "gooch",
                            "lommel-seeliger", "toon",       "cook-torrance"};
constexpr std::array surroundings{"sun", "studio", "lamps", "haze", "glow", "rim"};

Light lightOf(const Catalog& catalog, const char* kind, const glm::dvec3& color,
              const glm::dvec3& place) {
    Light light;
    light.block = defaultBlockValues(*catalog.find("lights", kind));
    light.block.parameters["color"] = color;
    const bool isSun = light.block.parameters.contains("direction");
    light.block.parameters[isSun ? "direction" : "position"] = place;
    return light;
}

/// The scene for which minimal/<surrounding>.frag is written.
Scene sceneOf(const Catalog& catalog, const std::string& model, const std::string& surrounding) {
    Scene scene;
    scene.objects.emplace_back();
    Material& material = scene.objects.front().material;
    material.model = defaultBlockValues(*catalog.find("models", model));
    scene.lights.push_back(
        lightOf(catalog, "directional", {1.0, 0.95, 0.88}, {0.55, -0.8, -0.75}));
    if (surrounding == "studio") {
        scene.lights.push_back(
            lightOf(catalog, "directional", {0.4, 0.45, 0.5}, {-1.0, -0.2, -0.35}));
        scene.lights.push_back(
            lightOf(catalog, "directional", {0.7, 0.7, 0.65}, {-0.35, -0.5, 1.0}));
    } else if (surrounding == "lamps") {
        scene.lights.push_back(lightOf(catalog, "point", {0.5, 0.6, 0.7}, {2.0, 3.0, 2.0}));
        scene.lights.back().block.parameters["attenuation.quadratic"] = 0.05;
    } else if (surrounding == "haze") {
        scene.fog = defaultBlockValues(*catalog.find("fog", "exponential"));
    } else if (surrounding == "glow") {
        material.model.parameters["emissive.color"] = glm::dvec3(0.05, 0.1, 0.2);
    } else if (surrounding == "rim") {
        material.parts["fresnel"] = defaultBlockValues(*catalog.find("fresnel", "schlick"));
    }
    return scene;
}

double largestDifference(const Image& a, const Image& b) {
    double largest = 0.0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const double off = std::abs(std::min(a.pixels[i], 1.0f) - std::min(b.pixels[i], 1.0f));
        largest = std::isnan(off) ? std::numeric_limits<double>::infinity()
                                  : std::max(largest, off);
    }
    return largest;
}

/// A model that calls the Fresnel term itself blends nothing.
bool isPossible(const Catalog& catalog, const std::string& model, const std::string& surrounding) {
    return surrounding != "rim" || catalog.find("models", model)->slot("fresnel") == nullptr;
}

struct Outcome {
    Spread ratio;
    double difference = 0.0;

    bool kept() const { return difference <= mostDifference && ratio.median <= mostRatio; }
};

/// Both in turn, each first as often as the other.
Outcome compare(BallStage& stage, AssembledProgram& assembled, MinimalProgram& minimal) {
    const auto useAssembled = [&assembled] { assembled.use(); };
    const auto useMinimal = [&minimal] { minimal.use(); };
    Outcome outcome;
    outcome.difference =
        largestDifference(stage.picture(useAssembled), stage.picture(useMinimal));
    std::vector<double> ratios;
    for (int round = 0; round < rounds; ++round) {
        const double first = stage.secondsPerFrame(useAssembled);
        const double byHand =
            stage.secondsPerFrame(useMinimal) + stage.secondsPerFrame(useMinimal);
        ratios.push_back((first + stage.secondsPerFrame(useAssembled)) / byHand);
    }
    outcome.ratio = spreadOf(ratios);
    return outcome;
}

void print(const std::string& name, const Outcome& outcome) {
    report("Assembled / by hand: " + name,
           fmt::format("{}; pictures differ by {:.1e}", text(outcome.ratio, 1.0, ""),
                       outcome.difference),
           outcome.kept(), "<= 1.05, pictures <= 1/255");
    std::fflush(stdout); // there are many, and each takes seconds
}

} // namespace

bool assembly() {
    BallStage stage;
    const auto catalog = std::make_shared<const Catalog>(loadCatalog(standardBlockRoots()));
    bool kept = true;
    std::vector<double> medians;
    for (const std::string model : models) {
        for (const std::string surrounding : surroundings) {
            if (!isPossible(*catalog, model, surrounding)) {
                continue;
            }
            const Scene scene = sceneOf(*catalog, model, surrounding);
            AssembledProgram assembled(catalog, scene, stage);
            MinimalProgram minimal(*catalog, model, surrounding, scene, stage);
            const Outcome outcome = compare(stage, assembled, minimal);
            print(model + ", " + surrounding, outcome);
            medians.push_back(outcome.ratio.median);
            kept = kept && outcome.kept();
        }
    }
    const double middle = spreadOf(medians).median;
    report(fmt::format("{} combinations: median of the medians", medians.size()),
           fmt::format("{:.3f}", middle), middle <= mostMedian, "<= 1.02");
    return kept && middle <= mostMedian;
}

} // namespace patina::benchmarks
