// SPDX-License-Identifier: GPL-3.0-or-later
// Whether models, and presets with each of their levels, that are predicted to be dear on a
// graphics card are dear where they are measured, and shaders without an effect cheaper.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <initializer_list>
#include <map>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "benchmarks.h"
#include "cpu_clock.h"
#include "material/blocks_in_use.h"
#include "material/measured_preset.h"
#include "measure/choice/choices.h"
#include "stage.h"
#include "statistics.h"
#include "support/program.h"

namespace patina::benchmarks {
namespace {

constexpr double wantedCorrelation = 0.9;
constexpr const char* families[] = {"gcn", "rdna2", "rdna3"};
constexpr glm::ivec2 frameSize{256, 256};
constexpr int rounds = 3;
constexpr double wantedShareOfEffects = 0.95;
constexpr std::size_t stepOfPresets = 4; ///< of those whose effects are left out

/// What `patina` says as JSON.
nlohmann::json said(std::vector<std::string> command) {
    command.emplace_back("--json");
    const tests::Outcome outcome =
        tests::run(PATINA_BINARY_DIR "/bin/patina", {.arguments = std::move(command),
                                                     .environment = {},
                                                     .input = {},
                                                     .timeLimitSeconds = 3600.0});
    return nlohmann::json::parse(outcome.out, nullptr, false);
}

/// What `patina cost` says under three lights.
nlohmann::json costs(std::vector<std::string> more) {
    const std::string scene = PATINA_SOURCE_DIR "/presets/three-lights.patina-scene.json";
    more.insert(more.begin(), {"cost", "--scene", scene});
    return said(std::move(more));
}

/// Returns the place of each number in the order of all; equal ones share the mean of theirs.
std::vector<double> ranks(const std::vector<double>& numbers) {
    std::vector<double> ranks;
    for (const double number : numbers) {
        const auto below = std::ranges::count_if(numbers, [=](double x) { return x < number; });
        const auto equal = std::ranges::count(numbers, number);
        ranks.push_back(double(below) + 0.5 * double(equal - 1));
    }
    return ranks;
}

/// Returns Spearman's rank correlation, -1 .. 1.
double rankCorrelation(const std::vector<double>& x, const std::vector<double>& y) {
    const std::vector<double> ranksOfX = ranks(x);
    const std::vector<double> ranksOfY = ranks(y);
    const double middle = 0.5 * double(x.size() - 1);
    double xy = 0.0;
    double xx = 0.0;
    double yy = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        xy += (ranksOfX[i] - middle) * (ranksOfY[i] - middle);
        xx += (ranksOfX[i] - middle) * (ranksOfX[i] - middle);
        yy += (ranksOfY[i] - middle) * (ranksOfY[i] - middle);
    }
    return xy / std::sqrt(xx * yy);
}

std::vector<std::string> shippedPresets() {
    std::vector<std::string> presets;
    for (const auto& file :
         std::filesystem::recursive_directory_iterator(PATINA_SOURCE_DIR "/presets")) {
        if (file.path().string().ends_with(".patina.json")) {
            presets.push_back(file.path().string());
        }
    }
    std::ranges::sort(presets);
    return presets;
}

/// Is a material at some levels, with what was predicted and measured of it.
struct Way {
    Material material;
    ChosenLevels levels;
    std::map<std::string, double> cycles{};  ///< by family
    std::map<std::string, double> latency{}; ///< by family, cycles of one wave alone
    double seconds = 0.0;                    ///< of processor time for a frame
    bool readsTable = false;
};

/// Returns a number of each family; nothing where a loop is in it, since how often it runs is the
/// compiler's guess.
std::map<std::string, double> numbersOf(const nlohmann::json& stages, const char* number) {
    std::map<std::string, double> numbers;
    for (const char* family : families) {
        if (stages.at(family).at("loops") != 0) {
            return {};
        }
        numbers[family] = stages.at(family).at(number);
    }
    return numbers;
}

/// Tells whether the object is drawn by its surface's shader alone, without images, which a
/// prediction leaves out.
bool isShadingAlone(const Material& material, const Catalog& catalog) {
    const Block* model = catalog.find(kinds::models, material.model.id);
    const bool hasMarks = std::ranges::any_of(
        std::initializer_list<std::string_view>{kinds::strokes, kinds::shells, kinds::outline,
                                                kinds::refraction},
        [&material](std::string_view kind) { return material.part(kind) != nullptr; });
    return model != nullptr && tableParameter(*model) == nullptr && material.textures.empty() &&
           !hasMarks;
}

/// Tells whether a level reads a table: a texture, which a software driver computes.
bool readsTable(const Way& way, const Catalog& catalog) {
    return std::ranges::any_of(blocksInUse(way.material, catalog), [&way](const Block* block) {
        return std::ranges::any_of(block->accuracy, [&](const AccuracyChoice& choice) {
            const auto level = std::ranges::find_if(way.levels, [&](const auto& each) {
                return each.first == choice.id || each.first.ends_with('.' + choice.id);
            });
            return level != way.levels.end() &&
                   std::ranges::any_of(choice.values, [&level](const EnumValue& value) {
                       return value.id == level->second && !value.table.empty();
                   });
        });
    });
}

void addWay(std::vector<Way>& ways, Way way, const nlohmann::json& predicted,
            const Catalog& catalog) {
    if (!isShadingAlone(way.material, catalog) || !predicted.contains("families")) {
        return;
    }
    way.cycles = numbersOf(predicted.at("families"), "cycles");
    way.latency = numbersOf(predicted.at("families"), "latency");
    way.readsTable = readsTable(way, catalog);
    if (!way.cycles.empty()) {
        ways.push_back(std::move(way));
    }
}

std::vector<Way> modelWays(const Catalog& catalog) {
    const nlohmann::json predicted = costs({"--all-models", "--gpu", "gcn,rdna2,rdna3"});
    std::vector<Way> ways;
    for (const auto& model : predicted.at("models")) {
        const std::string id = model.at("model");
        addWay(ways, {defaultMaterial(*catalog.find(kinds::models, id)), {}}, model, catalog);
    }
    return ways;
}

/// Returns all presets, each exact and with each of its levels.
std::vector<Way> presetWays(const Catalog& catalog) {
    std::vector<std::string> predict{"--gpu", "gcn,rdna2,rdna3"};
    for (const std::string& preset : shippedPresets()) {
        predict.push_back(preset);
    }
    const nlohmann::json predicted = costs(predict);
    std::vector<Way> ways;
    for (const auto& preset : predicted.at("presets")) {
        const Material material =
            readPreset(preset.at("preset").get<std::string>(), catalog).value().material;
        for (const auto& predictedWay : preset.at("ways")) {
            addWay(ways, {material, predictedWay.at("levels").get<ChosenLevels>()}, predictedWay,
                   catalog);
        }
    }
    return ways;
}

/// Measures ways in turns, a frame of each after the other. The smallest time counts: what others
/// on the machine take from a frame only makes it longer.
void measure(std::vector<Way>& ways) {
    Stage stage(frameSize);
    for (int round = 0; round <= rounds; ++round) {
        for (Way& way : ways) {
            ChosenFrame frame{stage.scene, stage.view};
            frame.scene.objects.front().material = way.material;
            choose(frame, 0, materialChoices(frame.scene, 0, stage.catalog()), way.levels,
                   stage.catalog());
            const double began = workSeconds();
            stage.draw(frame.scene);
            glFinish();
            const double seconds = workSeconds() - began;
            if (round > 0) { // the first one makes the program
                way.seconds = round == 1 ? seconds : std::min(way.seconds, seconds);
            }
        }
    }
}

/// Prints the ways whose places in both orders are farthest apart.
void printOutliers(const std::vector<Way>& ways, const std::vector<double>& predictions,
                   const std::vector<double>& times) {
    constexpr std::size_t printed = 12;
    const std::vector<double> predictedPlaces = ranks(predictions);
    const std::vector<double> measuredPlaces = ranks(times);
    std::vector<std::size_t> order(ways.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::ranges::sort(order, std::greater(), [&](std::size_t i) {
        return std::abs(predictedPlaces[i] - measuredPlaces[i]);
    });
    order.resize(std::min(order.size(), printed));
    for (const std::size_t i : order) {
        fmt::print("    {} {}: place {:.0f} predicted with {:.0f} cycles, {:.0f} measured with "
                   "{:.1f} ms\n",
                   ways[i].material.name, levelsText(ways[i].levels), predictedPlaces[i],
                   predictions[i], measuredPlaces[i], 1000.0 * times[i]);
    }
}

/// Prints how well a predicted number of the ways tells the order of their times; returns whether
/// that is well enough on all families.
bool areInOrder(const std::string& what, const std::vector<Way>& ways,
                std::map<std::string, double> Way::*number) {
    std::vector<double> times;
    for (const Way& way : ways) {
        times.push_back(way.seconds);
    }
    bool kept = true;
    for (const char* family : families) {
        std::vector<double> predictions;
        for (const Way& way : ways) {
            predictions.push_back((way.*number).at(family));
        }
        const double correlation = rankCorrelation(predictions, times);
        const bool isEnough = correlation >= wantedCorrelation;
        report(fmt::format("{} of {} on {}", what, ways.size(), family),
               fmt::format("{:.3f} rank correlation with measured times", correlation), isEnough,
               fmt::format("at least {}", wantedCorrelation));
        if (!isEnough) {
            printOutliers(ways, predictions, times);
        }
        kept = kept && isEnough;
    }
    return kept;
}

/// Counts pairs of a preset and an effect.
struct EffectPairs {
    int all = 0;
    int cheaper = 0; ///< without the effect
    std::vector<std::string> others;
};

/// Adds what the shader of a preset is predicted to be without each of its effects, in the default
/// scene with fog. Effects of other passes have no share in it.
void addEffectsOf(const std::string& preset, const std::string& family, EffectPairs& pairs) {
    const nlohmann::json json =
        said({"effects", preset, "--fog", "height", "--gpu", family, "--no-cost"});
    for (const auto& effect : json.at("effects")) {
        const auto predicted = effect.find("predicted");
        if (!effect.at("removable").get<bool>() || predicted == effect.end() ||
            !predicted->contains(family)) {
            continue;
        }
        const double cycles = predicted->at(family).at("cycles");
        const bool isOfOtherPass =
            cycles == 0.0 && predicted->at(family).at("instructions").get<double>() == 0.0;
        if (isOfOtherPass) {
            continue;
        }
        ++pairs.all;
        if (cycles > 0.0) {
            ++pairs.cheaper;
        } else {
            pairs.others.push_back(fmt::format("{}: {}, {} cycles",
                                               std::filesystem::path(preset).stem().string(),
                                               effect.at("effect").get<std::string>(), cycles));
        }
    }
}

} // namespace

bool removedEffects() {
    const std::string family = "rdna2";
    EffectPairs pairs;
    const std::vector<std::string> presets = shippedPresets();
    for (std::size_t i = 0; i < presets.size(); i += stepOfPresets) {
        addEffectsOf(presets[i], family, pairs);
    }
    const bool isEnough = pairs.cheaper >= wantedShareOfEffects * pairs.all;
    report("cheaper without an effect, on " + family,
           fmt::format("{} of {} pairs of an effect and a preset", pairs.cheaper, pairs.all),
           isEnough, fmt::format("{:.0f} %", 100.0 * wantedShareOfEffects));
    for (const std::string& other : pairs.others) {
        fmt::print("    {}\n", other);
    }
    return isEnough;
}

bool predictedCost() {
    const Catalog catalog = loadCatalog(standardBlockRoots());
    std::vector<Way> models = modelWays(catalog);
    measure(models);
    bool isKept = areInOrder("cycles of models", models, &Way::cycles);
    std::vector<Way> all = presetWays(catalog);
    measure(all);
    isKept = areInOrder("cycles of presets and levels", all, &Way::cycles) && isKept;
    areInOrder("latency of presets and levels", all, &Way::latency);
    std::erase_if(all, &Way::readsTable);
    return areInOrder("cycles of those without tables", all, &Way::cycles) && isKept;
}

} // namespace patina::benchmarks
