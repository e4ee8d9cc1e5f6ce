// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/choice/choices.h"

#include <algorithm>
#include <optional>
#include <sstream>

#include <fmt/format.h>

#include "catalog/wavelength_ray_choices.h"
#include "measure/choice/picture_choices.h"
#include "shading/effects/effect_set.h"
#include "shading/effects/refracted_wavelengths.h"

namespace patina {
namespace {

/// Tells whether no level of the choice is in the program, whichever is chosen.
bool isWithoutEffect(const BlockUse& use, const AccuracyChoice& choice, const EffectSet& set) {
    return (&choice == wavelengthChoice(use.block()) && wavelengthCount(use) == 0) ||
           (&choice == rayChoice(use.block()) && !set.isShownRefracted);
}

void addBlock(std::vector<Choice>& choices, const BlockUse& use, const EffectSet& set,
              const std::string& prefix) {
    const Block& block = use.block();
    for (const AccuracyChoice& accuracy : block.accuracy) {
        const bool isKnown = std::ranges::any_of(
            choices, [&accuracy](const Choice& known) { return known.key == accuracy.id; });
        if (isKnown || accuracy.values.size() < 2 || isWithoutEffect(use, accuracy, set)) {
            continue;
        }
        Choice choice{Choice::Scope::Material,
                      prefix + accuracy.id,
                      accuracy.id,
                      accuracy.label,
                      accuracy.doc,
                      block.label,
                      {}};
        for (const EnumValue& value : accuracy.values) {
            choice.levels.push_back({value.id, value.label, value.doc});
        }
        choices.push_back(std::move(choice));
    }
}

const std::string& levelOf(const Choice& choice, const ChosenLevels& levels) {
    const auto found = levels.find(choice.id);
    return found == levels.end() ? choice.levels.front().id : found->second;
}

} // namespace

const ChoiceLevel* Choice::level(std::string_view levelId) const {
    const auto found = std::ranges::find_if(
        levels, [levelId](const ChoiceLevel& each) { return each.id == levelId; });
    return found == levels.end() ? nullptr : &*found;
}

std::vector<Choice> materialChoices(const Scene& scene, std::size_t object,
                                    const Catalog& catalog) {
    std::vector<Choice> choices;
    if (object >= scene.objects.size()) {
        return choices;
    }
    const EffectSet set = effectSet(scene.objects[object].material, scene, catalog);
    if (set.model) {
        addBlock(choices, *set.model, set, {});
    }
    for (const BlockUse& slot : set.slots) {
        addBlock(choices, slot, set, slot.block().kind + '.');
    }
    for (const std::optional<BlockUse>& part :
         {set.blend, set.refraction, set.shells, set.strokes}) {
        if (part) {
            addBlock(choices, *part, set, part->block().kind + '.');
        }
    }
    return choices;
}

ChosenLevels levelsOf(const Material& material, const std::vector<Choice>& choices) {
    ChosenLevels levels;
    for (const Choice& choice : choices) {
        const auto found = material.accuracy.find(choice.key);
        if (found != material.accuracy.end() && choice.level(found->second) != nullptr &&
            found->second != choice.levels.front().id) {
            levels[choice.id] = found->second;
        }
    }
    return levels;
}

std::vector<bool> sharingMaterial(const Scene& scene, std::size_t object) {
    std::vector<bool> sharing;
    for (const Object& each : scene.objects) {
        sharing.push_back(each.material == scene.objects[object].material);
    }
    return sharing;
}

void choose(ChosenFrame& frame, std::size_t object, const std::vector<Choice>& choices,
            const ChosenLevels& levels, const Catalog& catalog) {
    const std::vector<bool> sharing = sharingMaterial(frame.scene, object);
    for (const Choice& choice : choices) {
        const std::string& level = levelOf(choice, levels);
        if (choice.scope == Choice::Scope::Picture) {
            choosePicture(frame, choice, level, catalog);
            continue;
        }
        for (std::size_t i = 0; i < sharing.size(); ++i) {
            if (sharing[i]) {
                frame.scene.objects[i].material.accuracy[choice.key] = level;
            }
        }
    }
}

std::optional<ChosenLevels> levelsFromText(const std::string& text) {
    ChosenLevels levels;
    if (text == levelsText({})) {
        return levels;
    }
    std::istringstream words(text);
    for (std::string word; words >> word;) {
        const auto sign = word.find('=');
        if (sign == std::string::npos || sign == 0 || sign + 1 == word.size()) {
            return std::nullopt;
        }
        levels[word.substr(0, sign)] = word.substr(sign + 1);
    }
    return levels.empty() ? std::nullopt : std::optional(levels);
}

std::string levelsText(const ChosenLevels& levels) {
    std::string text;
    for (const auto& [choice, level] : levels) {
        text += fmt::format("{}{}={}", text.empty() ? "" : " ", choice, level);
    }
    return text.empty() ? "exact" : text;
}

} // namespace patina
