// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/picture_choices.h"

#include <algorithm>
#include <array>
#include <cstdlib>

#include <fmt/format.h>

#include "scene/transparency.h"
#include "shading/effect_choice.h"

namespace patina {
namespace {

/// A choice of the picture's own: one row of the table below, and no edit elsewhere.
struct PictureRow {
    const char* id;
    const char* label;
    const char* doc;
    std::vector<ChoiceLevel> (*levels)(const Scene& scene, const Catalog& catalog);
    void (*apply)(ChosenFrame& frame, const std::string& level, const Catalog& catalog);
};

int numberOf(const std::string& level) {
    return std::atoi(level.c_str());
}

/// "8", "4", ...: each with a label such as "8 samples".
std::vector<ChoiceLevel> counted(std::initializer_list<int> counts, std::string_view what) {
    std::vector<ChoiceLevel> levels;
    for (const int count : counts) {
        const std::string number = std::to_string(count);
        levels.push_back({number, fmt::format("{} {}", number, what), {}});
    }
    return levels;
}

std::vector<ChoiceLevel> sampleLevels(const Scene&, const Catalog&) {
    return counted({8, 4, 2, 1}, "samples");
}

void applySamples(ChosenFrame& frame, const std::string& level, const Catalog&) {
    frame.view.samples = numberOf(level);
}

std::vector<ChoiceLevel> numberLevels(const Scene&, const Catalog&) {
    return {{"full", "32 bits", "Seven digits per channel."},
            {"half", "16 bits", "Three digits per channel, half the memory."}};
}

void applyNumbers(ChosenFrame& frame, const std::string& level, const Catalog&) {
    frame.view.numbers = level == "full" ? HdrNumbers::Full : HdrNumbers::Half;
}

std::vector<ChoiceLevel> environmentLevels(const Scene& scene, const Catalog& catalog) {
    if (environmentChoice(scene, catalog).block == nullptr) {
        return {};
    }
    return counted({4096, 1024, 256, 64, 16, 4}, "directions");
}

void applyEnvironment(ChosenFrame& frame, const std::string& level, const Catalog&) {
    frame.view.environmentSamples = numberOf(level);
}

/// From the most that the block can down, halving.
std::vector<ChoiceLevel> layerLevels(const Scene& scene, const Catalog& catalog) {
    const Block* block = transparencyBlock(scene, catalog);
    const Parameter* layers = block == nullptr ? nullptr : layersParameter(*block);
    std::vector<ChoiceLevel> levels;
    for (int n = layers == nullptr ? 0 : static_cast<int>(layers->max); n >= 1; n /= 2) {
        levels.push_back(counted({n}, "layers").front());
    }
    return levels;
}

void applyLayers(ChosenFrame& frame, const std::string& level, const Catalog& catalog) {
    const Block* block = transparencyBlock(frame.scene, catalog);
    const Parameter* layers = block == nullptr ? nullptr : layersParameter(*block);
    if (layers != nullptr) {
        frame.scene.transparency->parameters[layers->id] = numberOf(level);
    }
}

constexpr std::array rows{
    PictureRow{"picture.samples", "Samples per pixel",
               "How many places of a pixel are looked at for edges.", sampleLevels, applySamples},
    PictureRow{"picture.numbers", "Linear picture",
               "How fine the numbers are in which light is summed up.", numberLevels,
               applyNumbers},
    PictureRow{"picture.environment", "Environment",
               "How many directions per pixel the light from all around is a mean of.",
               environmentLevels, applyEnvironment},
    PictureRow{"picture.layers", "Layers",
               "How many surfaces behind each other are put in their order.", layerLevels,
               applyLayers},
};

} // namespace

std::vector<Choice> pictureChoices(const Scene& scene, const Catalog& catalog) {
    std::vector<Choice> choices;
    for (const PictureRow& row : rows) {
        std::vector<ChoiceLevel> levels = row.levels(scene, catalog);
        if (levels.size() > 1) {
            choices.push_back({Choice::Scope::Picture, row.id, row.id, row.label, row.doc,
                               "Picture", std::move(levels)});
        }
    }
    return choices;
}

void choosePicture(ChosenFrame& frame, const Choice& choice, const std::string& level,
                   const Catalog& catalog) {
    for (const PictureRow& row : rows) {
        if (row.id == choice.id) {
            row.apply(frame, level, catalog);
        }
    }
}

} // namespace patina
