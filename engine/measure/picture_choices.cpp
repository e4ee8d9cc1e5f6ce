// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/picture_choices.h"

#include <algorithm>
#include <array>
#include <cstdlib>

#include <fmt/format.h>

#include "scene/picture_choice_text.h"
#include "scene/transparency.h"
#include "shading/effect_choice.h"
#include "shading/effect_set.h"

namespace patina {
namespace {

/// A choice that is no level of Scene::accuracy: one row of the table below, and no edit elsewhere.
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

std::vector<ChoiceLevel> environmentLevels(const Scene& scene, const Catalog& catalog) {
    if (environmentChoice(scene, catalog).block == nullptr) {
        return {};
    }
    return counted({4096, 1024, 256, 64, 16, 4}, "directions");
}

void applyEnvironment(ChosenFrame& frame, const std::string& level, const Catalog&) {
    frame.view.environmentSamples = numberOf(level);
}

/// A kind of transparency by its id that mixes all surfaces at once; null where there is none.
const Block* mixing(const Catalog& catalog, const std::string& id) {
    const Block* block = catalog.find("transparency", id);
    return block != nullptr && layersParameter(*block) == nullptr ? block : nullptr;
}

/// From the most that the block can down, halving; then what mixes all layers at once.
std::vector<ChoiceLevel> layerLevels(const Scene& scene, const Catalog& catalog) {
    const Block* block = transparencyBlock(scene, catalog);
    const Parameter* layers = block == nullptr ? nullptr : layersParameter(*block);
    if (layers == nullptr) {
        return {};
    }
    std::vector<ChoiceLevel> levels;
    for (int n = static_cast<int>(layers->max); n >= 1; n /= 2) {
        levels.push_back(counted({n}, "layers").front());
    }
    for (const Block* other : catalog.ofKind("transparency")) {
        if (mixing(catalog, other->id) != nullptr) {
            levels.push_back({other->id, other->label, other->summary});
        }
    }
    return levels;
}

void applyLayers(ChosenFrame& frame, const std::string& level, const Catalog& catalog) {
    if (const Block* mixed = mixing(catalog, level)) {
        frame.scene.transparency = BlockValues{mixed->id, mixed->version, defaultValues(*mixed)};
        return;
    }
    const Block* block = transparencyBlock(frame.scene, catalog);
    const Parameter* layers = block == nullptr ? nullptr : layersParameter(*block);
    if (layers != nullptr) {
        frame.scene.transparency->parameters[layers->id] = numberOf(level);
    }
}

/// What says how many places a kind of shadow looks at; null where nothing does.
const Parameter* tapsOf(const Light& light, const Catalog& catalog) {
    const Block* block = light.shadow ? catalog.find("shadows", light.shadow->id) : nullptr;
    const Parameter* taps = block == nullptr ? nullptr : block->parameter("samples");
    return taps != nullptr && taps->type == ParameterType::Enum ? taps : nullptr;
}

/// Of the first light that has such shadows; their finest level is listed last.
std::vector<ChoiceLevel> tapLevels(const Scene& scene, const Catalog& catalog) {
    std::vector<ChoiceLevel> levels;
    for (std::size_t i = 0; i < scene.lights.size() && levels.empty(); ++i) {
        const Parameter* taps = hasShadows(scene, catalog) && scene.lights[i].enabled
                                    ? tapsOf(scene.lights[i], catalog)
                                    : nullptr;
        for (const EnumValue& value : taps == nullptr ? std::vector<EnumValue>() : taps->values) {
            levels.insert(levels.begin(), ChoiceLevel{value.id, value.label, value.doc});
        }
    }
    return levels;
}

void applyTaps(ChosenFrame& frame, const std::string& level, const Catalog& catalog) {
    for (Light& light : frame.scene.lights) {
        const Parameter* taps = tapsOf(light, catalog);
        const bool hasLevel =
            taps != nullptr && std::ranges::any_of(taps->values, [&](const EnumValue& value) {
                return value.id == level;
            });
        if (hasLevel) {
            light.shadow->parameters[taps->id] = level;
        }
    }
}

constexpr std::array rows{
    PictureRow{"picture.environment", "Environment",
               "How many directions per pixel the light from all around is a mean of.",
               environmentLevels, applyEnvironment},
    PictureRow{"picture.layers", "Layers",
               "How many surfaces behind each other are put in their order.", layerLevels,
               applyLayers},
    PictureRow{"picture.shadows", "Shadow edges",
               "How many places of a depth map a shadow's edge is a mean of.", tapLevels,
               applyTaps},
};

constexpr std::string_view prefix = "picture.";

/// Whether anything of the scene depends on it.
bool counts(PictureChoice choice, const Scene& scene, const Catalog& catalog) {
    return choice != PictureChoice::Fog || sceneEffects(scene, catalog).fog.has_value();
}

Choice choiceOf(const PictureChoiceText& text) {
    const std::string id = std::string(prefix) + text.id;
    Choice choice{Choice::Scope::Picture, id, id, text.label, text.doc, "Picture", {}};
    for (const PictureChoiceText::Level& level : text.levels) {
        choice.levels.push_back({level.id, level.label, level.doc});
    }
    return choice;
}

} // namespace

std::vector<Choice> choicesOfPicture(const Scene& scene, const Catalog& catalog) {
    std::vector<Choice> choices;
    for (const PictureRow& row : rows) {
        std::vector<ChoiceLevel> levels = row.levels(scene, catalog);
        if (levels.size() > 1) {
            choices.push_back({Choice::Scope::Picture, row.id, row.id, row.label, row.doc,
                               "Picture", std::move(levels)});
        }
    }
    for (const PictureChoiceText& text : pictureChoiceTexts()) {
        if (counts(text.choice, scene, catalog)) {
            choices.push_back(choiceOf(text));
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
    const std::string_view id = choice.id;
    const PictureChoiceText* text =
        id.starts_with(prefix) ? pictureChoiceText(id.substr(prefix.size())) : nullptr;
    if (const auto number = text == nullptr ? std::nullopt : text->level(level)) {
        frame.scene.accuracy.choose(text->choice, *number);
    }
}

} // namespace patina
