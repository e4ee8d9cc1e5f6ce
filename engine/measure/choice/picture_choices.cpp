// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/choice/picture_choices.h"

#include <algorithm>
#include <array>
#include <iterator>

#include <fmt/format.h>

#include "measure/choice/pass_choices.h"
#include "scene/environment.h"
#include "scene/picture_choice_text.h"
#include "scene/transparency.h"
#include "shading/effects/effect_set.h"

namespace patina {
namespace {

/// Describes a choice that is not in Scene::accuracy. Another one is a row of the table below and
/// needs no edit elsewhere.
struct PictureRow {
    const char* id;
    const char* label;
    const char* doc;
    std::vector<ChoiceLevel> (*levels)(const Scene& scene, const Catalog& catalog);
    void (*apply)(ChosenFrame& frame, const std::string& level, const Catalog& catalog);
    /// Returns the level that the scene has, which may be none of `levels`; empty where the choice
    /// has no effect on the scene.
    std::string (*current)(const Scene& scene, const Catalog& catalog);
};

int numberOf(const std::string& level) {
    return std::atoi(level.c_str());
}

/// Returns the level "8" with a label such as "8 layers".
ChoiceLevel counted(int count, std::string_view what) {
    const std::string number = std::to_string(count);
    return {number, fmt::format("{} {}", number, what), {}};
}

const PictureChoiceText::Level& fittedLevel() {
    return pictureChoiceText("environment")->levels[1];
}

std::vector<ChoiceLevel> environmentLevels(const Scene& scene, const Catalog& catalog) {
    const Block* block = environmentChoice(scene, catalog).block;
    const Parameter* directions = block == nullptr ? nullptr : directionsParameter(*block);
    std::vector<ChoiceLevel> levels;
    if (block == nullptr) {
        return levels;
    }
    for (const int count : {4096, 1024, 256, 64, 16, 4, 1}) {
        if (directions != nullptr && count >= directions->min && count <= directions->max) {
            levels.push_back(counted(count, count == 1 ? "direction" : "directions"));
        }
    }
    const PictureChoiceText::Level& fitted = fittedLevel();
    levels.push_back({fitted.id, fitted.label, fitted.doc});
    return levels;
}

void applyEnvironment(ChosenFrame& frame, const std::string& level, const Catalog& catalog) {
    const Block* block = environmentChoice(frame.scene, catalog).block;
    const Parameter* directions = block == nullptr ? nullptr : directionsParameter(*block);
    const bool isFitted = level == fittedLevel().id;
    frame.scene.accuracy.choose(PictureChoice::Environment, isFitted ? 1 : 0);
    if (directions != nullptr && !isFitted) {
        frame.scene.part(kinds::environment)->parameters[directions->id] = numberOf(level);
        frame.view.environmentSamples = numberOf(level);
    }
}

std::string currentEnvironment(const Scene& scene, const Catalog& catalog) {
    const Block* block = environmentChoice(scene, catalog).block;
    if (scene.accuracy.fitsEnvironment()) {
        return block == nullptr ? std::string() : fittedLevel().id;
    }
    return block == nullptr ? std::string()
                            : std::to_string(directionsOf(*scene.part(kinds::environment), *block));
}

/// Returns a transparency block that sorts: the scene's own, else the catalogue's first; null where
/// there is none.
const Block* sortingBlock(const Scene& scene, const Catalog& catalog) {
    const Block* own = transparencyBlock(scene, catalog);
    if (own != nullptr && layersParameter(*own) != nullptr) {
        return own;
    }
    const std::vector<const Block*> all = catalog.ofKind(kinds::transparency);
    const auto found = std::ranges::find_if(
        all, [](const Block* block) { return layersParameter(*block) != nullptr; });
    return found == all.end() ? nullptr : *found;
}

/// Returns the most layers that the sorting block can do, halved down to 1, and then the blocks
/// that mix all at once. Empty where nothing in the scene is transparent.
std::vector<ChoiceLevel> layerLevels(const Scene& scene, const Catalog& catalog) {
    std::vector<ChoiceLevel> levels;
    if (transparencyBlock(scene, catalog) == nullptr) {
        return levels;
    }
    const Block* sorting = sortingBlock(scene, catalog);
    const int maxLayers = sorting == nullptr ? 0 : static_cast<int>(layersParameter(*sorting)->max);
    for (int n = maxLayers; n >= 1; n /= 2) {
        levels.push_back(counted(n, n == 1 ? "layer" : "layers"));
    }
    for (const Block* block : catalog.ofKind(kinds::transparency)) {
        if (layersParameter(*block) == nullptr) {
            levels.push_back({block->id, block->label, block->summary});
        }
    }
    return levels;
}

/// Makes this block the scene's transparency, with its defaults where it was another one, and
/// returns its values.
BlockValues& useTransparency(Scene& scene, const Block& block) {
    const BlockValues* held = scene.part(kinds::transparency);
    if (held == nullptr || held->id != block.id) {
        BlockValues values;
        values.id = block.id;
        values.version = block.version;
        values.parameters = defaultValues(block);
        scene.setPart(kinds::transparency, std::move(values));
    }
    return *scene.part(kinds::transparency);
}

void applyLayers(ChosenFrame& frame, const std::string& level, const Catalog& catalog) {
    if (const Block* mixing = catalog.find(kinds::transparency, level)) {
        useTransparency(frame.scene, *mixing);
    } else if (const Block* sorting = sortingBlock(frame.scene, catalog)) {
        useTransparency(frame.scene, *sorting).parameters[layersParameter(*sorting)->id] =
            numberOf(level);
    }
}

std::string currentLayers(const Scene& scene, const Catalog& catalog) {
    const Block* block = transparencyBlock(scene, catalog);
    if (block == nullptr || layersParameter(*block) == nullptr) {
        return block == nullptr ? std::string() : block->id;
    }
    return std::to_string(layersOf(*scene.part(kinds::transparency), *block));
}

/// Returns the parameter that says how many taps the light's shadow takes of its depth map; null
/// where it has none.
const Parameter* tapsOf(const Light& light, const Catalog& catalog) {
    const Block* block = blockOf(light.parts, kinds::shadows, catalog);
    return block == nullptr ? nullptr : block->withRole(roles::samples);
}

/// Returns the first enabled light that has such a parameter; null where there is none or the scene
/// has no shadows.
const Light* tappedLight(const Scene& scene, const Catalog& catalog) {
    const auto found = std::ranges::find_if(scene.lights, [&catalog](const Light& light) {
        return light.enabled && tapsOf(light, catalog) != nullptr;
    });
    return found != scene.lights.end() && hasShadows(scene, catalog) ? &*found : nullptr;
}

/// Returns the levels of those taps in reverse, since the parameter lists the finest one last.
std::vector<ChoiceLevel> tapLevels(const Scene& scene, const Catalog& catalog) {
    std::vector<ChoiceLevel> levels;
    if (const Light* light = tappedLight(scene, catalog)) {
        for (const EnumValue& value : tapsOf(*light, catalog)->values) {
            levels.insert(levels.begin(), ChoiceLevel{value.id, value.label, value.doc});
        }
    }
    return levels;
}

std::string currentTaps(const Scene& scene, const Catalog& catalog) {
    const Light* light = tappedLight(scene, catalog);
    if (light == nullptr) {
        return {};
    }
    const Parameter& taps = *tapsOf(*light, catalog);
    const Values& values = light->part(kinds::shadows)->parameters;
    const auto given = values.find(taps.id);
    const bool isGiven = given != values.end();
    return std::get<std::string>(conformed(taps, isGiven ? given->second : taps.defaultValue));
}

void applyTaps(ChosenFrame& frame, const std::string& level, const Catalog& catalog) {
    for (Light& light : frame.scene.lights) {
        const Parameter* taps = tapsOf(light, catalog);
        const bool hasLevel =
            taps != nullptr && std::ranges::any_of(taps->values, [&](const EnumValue& value) {
                return value.id == level;
            });
        if (hasLevel) {
            light.part(kinds::shadows)->parameters[taps->id] = level;
        }
    }
}

constexpr const char* directionsChoice = "picture.environment";

constexpr std::array rows{
    PictureRow{directionsChoice, "Environment",
               "How many directions per pixel the light from all around is a mean of.",
               environmentLevels, applyEnvironment, currentEnvironment},
    PictureRow{"picture.layers", "Layers",
               "How many surfaces behind each other are put in their order, or that all are mixed "
               "at once.",
               layerLevels, applyLayers, currentLayers},
    PictureRow{"picture.shadows", "Shadow edges",
               "How many places of a depth map a shadow's edge is a mean of.", tapLevels, applyTaps,
               currentTaps},
};

constexpr std::string_view prefix = "picture.";

/// Tells whether the choice has an effect on the scene and is not in the table above.
bool counts(PictureChoice choice, const Scene& scene, const Catalog& catalog) {
    if (choice == PictureChoice::Environment) {
        return false; // its row in the table has "fitted" as a level
    }
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

/// Returns the texts of a choice of Scene::accuracy; null for the choices of the table above,
/// except that of the environment.
const PictureChoiceText* textOf(const Choice& choice) {
    const std::string_view id = choice.id;
    return id.starts_with(prefix) ? pictureChoiceText(id.substr(prefix.size())) : nullptr;
}

std::string currentLevel(const Scene& scene, const Choice& choice, const Catalog& catalog) {
    for (const PictureRow& row : rows) {
        if (row.id == choice.id) {
            return row.current(scene, catalog);
        }
    }
    const PictureChoiceText* text = textOf(choice);
    return text == nullptr ? passLevel(scene, choice, catalog)
                           : text->levels[scene.accuracy.level(text->choice)].id;
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
    std::ranges::move(choicesOfPasses(scene, catalog), std::back_inserter(choices));
    return choices;
}

ChosenLevels levelsOfPicture(const Scene& scene, const std::vector<Choice>& choices,
                             const Catalog& catalog) {
    ChosenLevels levels;
    for (const Choice& choice : choices) {
        const std::string current = currentLevel(scene, choice, catalog);
        if (!current.empty() && current != choice.levels.front().id) {
            levels[choice.id] = current;
        }
    }
    return levels;
}

bool isOfSamples(const Choice& choice) {
    const PictureChoiceText* text = textOf(choice);
    return text != nullptr && text->choice == PictureChoice::Samples;
}

bool isOfDirections(const Choice& choice) {
    return choice.id == directionsChoice;
}

void choosePicture(ChosenFrame& frame, const Choice& choice, const std::string& level,
                   const Catalog& catalog) {
    for (const PictureRow& row : rows) {
        if (row.id == choice.id) {
            row.apply(frame, level, catalog);
        }
    }
    choosePass(frame.scene, choice, level, catalog);
    const PictureChoiceText* text = textOf(choice);
    if (const auto number = text == nullptr ? std::nullopt : text->level(level)) {
        frame.scene.accuracy.choose(text->choice, *number);
    }
}

} // namespace patina
