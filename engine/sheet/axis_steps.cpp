// SPDX-License-Identifier: GPL-3.0-or-later
#include "sheet/axis_steps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "catalog/fills.h"
#include "catalog/suggestion.h"
#include "core/number_text.h"
#include "material/accuracy_text.h"
#include "material/block_values.h"
#include "material/blocks_in_use.h"
#include "material/material_assignment.h"
#include "material/model_swap.h"
#include "scene/environment_choice.h"
#include "scene/picture_choice_text.h"
#include "scene/picture_levels.h"
#include "scene/scene_assignment.h"

namespace patina {
namespace {

constexpr const char* exactWord = "exact";
constexpr const char* allWord = "all";

std::string noneWordOf(std::string_view kind) {
    return std::string(findKind(kind)->noneWord);
}

Material& materialOf(Scene& scene, std::size_t object) {
    return scene.objects[object].material;
}

// Models.

Result<void> applyModel(Scene& scene, std::size_t object, const std::string& id,
                        const Catalog& catalog) {
    Material& material = materialOf(scene, object);
    return knownBlock(catalog, kinds::models, id).map([&](const Block* model) {
        material = swappedModel(material, *model, catalog);
    });
}

// Accuracy.

std::vector<const AccuracyChoice*> choicesOf(const Material& material, const Catalog& catalog) {
    std::vector<const AccuracyChoice*> choices;
    for (const Block* block : blocksInUse(material, catalog)) {
        for (const AccuracyChoice& choice : block->accuracy) {
            choices.push_back(&choice);
        }
    }
    return choices;
}

std::vector<std::string> wordsIn(const std::string& text) {
    std::vector<std::string> words;
    std::size_t at = 0;
    while (at < text.size()) {
        const std::size_t end = std::min(text.find(' ', at), text.size());
        if (end > at) {
            words.push_back(text.substr(at, end - at));
        }
        at = end + 1;
    }
    return words;
}

/// Sets the named levels; every choice that the words do not name becomes exact.
Result<void> applyLevels(Scene& scene, std::size_t object, const std::string& levels,
                         const Catalog& catalog) {
    Material& material = materialOf(scene, object);
    for (const AccuracyChoice* choice : choicesOf(material, catalog)) {
        material.accuracy[choice->id] = choice->values.front().id;
    }
    for (const std::string& word : wordsIn(levels == exactWord ? std::string() : levels)) {
        const auto assignment = assignmentFrom(word);
        if (!assignment) {
            return failure(fmt::format("\"{}\" is no accuracy level", word),
                           "choice=level, or exact");
        }
        const auto done = setLevel(material, assignment->id, assignment->text, catalog);
        if (!done) {
            return tl::unexpected(done.error());
        }
        if (!*done) {
            std::vector<std::string> known;
            for (const AccuracyChoice* choice : choicesOf(material, catalog)) {
                known.push_back(choice->id);
            }
            return failure(
                fmt::format("the material has no accuracy choice \"{}\"", assignment->id),
                oneOf(assignment->id, known));
        }
    }
    return {};
}

std::string labelOfLevels(const Material& material, const std::string& levels,
                          const Catalog& catalog) {
    std::string label;
    for (const std::string& word : wordsIn(levels == exactWord ? std::string() : levels)) {
        const std::size_t equals = std::min(word.find('='), word.size());
        const std::string level = equals < word.size() ? word.substr(equals + 1) : word;
        const AccuracyChoice* choice = accuracyChoiceIn(material, word.substr(0, equals), catalog);
        const std::size_t place = choice == nullptr ? 0 : indexOf(choice->values, level);
        label +=
            (label.empty() ? "" : ", ") + (choice == nullptr ? word : choice->values[place].label);
    }
    return label.empty() ? "Exact" : label;
}

/// Returns the entry for everything exact, and one entry for each inexact level on its own.
std::vector<std::string> everyLevel(const Material& material, const Catalog& catalog) {
    std::vector<std::string> all{exactWord};
    for (const AccuracyChoice* choice : choicesOf(material, catalog)) {
        for (std::size_t i = 1; i < choice->values.size(); ++i) {
            const std::string way = fmt::format("{}={}", choice->id, choice->values[i].id);
            if (std::ranges::find(all, way) == all.end()) {
                all.push_back(way);
            }
        }
    }
    return all;
}

// Lights and environments.

Result<void> applyLights(Scene& scene, const std::string& entry, const Catalog& catalog) {
    if (entry == allWord) {
        return {};
    }
    if (entry == noneWordOf(kinds::lights)) {
        scene.lights.clear();
        return {};
    }
    if (const Light* alone = lightNamed(scene, entry)) {
        for (Light& light : scene.lights) {
            light.enabled = &light == alone;
        }
        return {};
    }
    if (const Block* block = catalog.find(kinds::lights, entry)) {
        scene.lights.assign(1, {block->label, true, defaultBlockValues(*block)});
        return {};
    }
    std::vector<std::string> known{allWord, noneWordOf(kinds::lights)};
    for (const Light& light : scene.lights) {
        known.push_back(light.name);
    }
    for (const Block* block : catalog.ofKind(kinds::lights)) {
        known.push_back(block->id);
    }
    return failure(fmt::format("there is no light \"{}\"", entry), oneOf(entry, known));
}

std::string labelOfLights(Scene scene, const std::string& entry, const Catalog& catalog) {
    if (entry == allWord) {
        return "All lights";
    }
    if (const Light* light = lightNamed(scene, entry)) {
        return light->name;
    }
    const Block* block = catalog.find(kinds::lights, entry);
    return block == nullptr ? "No light" : block->label;
}

/// Returns entries for the scene's lights together and for each alone; where it has fewer than two,
/// for each light block in place of them.
std::vector<std::string> everyLight(const Scene& scene, const Catalog& catalog) {
    std::vector<std::string> all{allWord};
    if (scene.lights.size() > 1) {
        for (const Light& light : scene.lights) {
            all.push_back(light.name);
        }
        return all;
    }
    for (const Block* block : catalog.ofKind(kinds::lights)) {
        all.push_back(block->id);
    }
    return all;
}

/// Chooses an environment; the scene's own one keeps its values.
Result<void> applyEnvironment(Scene& scene, const std::string& entry, const Catalog& catalog) {
    const BlockValues* held = scene.part(kinds::environment);
    return held != nullptr && held->id == entry ? Result<void>()
                                                : chooseEnvironment(scene, entry, catalog);
}

std::string labelOfEnvironment(const std::string& entry, const Catalog& catalog) {
    if (entry == noneWordOf(kinds::environment)) {
        return "None";
    }
    const Block* block = catalog.find(kinds::environment, entry);
    return block == nullptr ? std::filesystem::path(entry).stem().string() : block->label;
}

std::vector<std::string> everyBlock(std::string_view kind, const Catalog& catalog) {
    std::vector<std::string> all;
    for (const Block* block : catalog.ofKind(kind)) {
        all.push_back(block->id);
    }
    return all;
}

/// Returns "none" and the environments' ids. One that needs an image file is left out unless it is
/// the scene's own, since nobody has named a file for it.
std::vector<std::string> everyEnvironment(const Scene& scene, const Catalog& catalog) {
    std::vector<std::string> all{noneWordOf(kinds::environment)};
    const BlockValues* held = scene.part(kinds::environment);
    for (const Block* block : catalog.ofKind(kinds::environment)) {
        const bool needsFile = std::ranges::any_of(
            block->parameters, [](const Parameter& each) { return infoOf(each.type).isFile; });
        if (!needsFile || (held != nullptr && held->id == block->id)) {
            all.push_back(block->id);
        }
    }
    return all;
}

// Values.

Result<void> applyValue(Scene& scene, std::size_t object, const std::string& id,
                        const std::string& text, const Catalog& catalog) {
    const std::string assignment = id + '=' + text;
    return isForScene(assignment, catalog)
               ? assignInScene(scene, assignment, catalog, object)
               : assignInMaterial(materialOf(scene, object), assignment, catalog);
}

NamedParameter parameterOf(const Scene& scene, std::size_t object, const std::string& id,
                           const Catalog& catalog) {
    return isForScene(id + '=', catalog)
               ? parameterIn(scene, id, catalog)
               : NamedParameter{parameterIn(scene.objects[object].material, id, catalog)};
}

/// Returns a number with at most the parameter's decimals and without trailing zeros.
std::string roundedText(double number, const Parameter& parameter) {
    const int decimals = std::clamp(parameter.decimals, 0, 9);
    const std::string text = fmt::format("{:.{}f}", number, decimals);
    return shortestFloatText(parseNumber(text).value_or(number));
}

std::string labelOfValue(const Parameter* parameter, const std::string& text) {
    if (parameter == nullptr) {
        return text;
    }
    if (infoOf(parameter->type).isChoice) {
        const std::size_t place = indexOf(parameter->values, text);
        return place < parameter->values.size() ? parameter->values[place].label : text;
    }
    const std::optional<double> number = parseNumber(text);
    return number ? roundedText(*number, *parameter) : text;
}

double alongRange(const SheetRange& range, const Parameter& parameter, int step) {
    const double share = range.steps > 1 ? double(step) / double(range.steps - 1) : 0.0;
    const bool isLog = parameter.scale == Scale::Log && range.from > 0.0 && range.to > 0.0;
    const double number = isLog ? range.from * std::pow(range.to / range.from, share)
                                : range.from + share * (range.to - range.from);
    const bool isEnd = step == range.steps - 1 && range.steps > 1;
    return isEnd ? range.to : number; // rounding could miss the end
}

std::vector<std::string> rangeEntries(const SheetRange& range, const Parameter& parameter) {
    std::vector<std::string> entries;
    for (int i = 0; i < range.steps; ++i) {
        const double number = alongRange(range, parameter, i);
        entries.push_back(
            shortestFloatText(infoOf(parameter.type).isWhole ? std::round(number) : number));
    }
    return entries;
}

/// Fills an axis that names no steps: with all choices of an enum, both states of a switch, or the
/// slider's range of a number. It is an error for any other type.
Result<void> chooseEntries(SheetAxis& axis, const Parameter& parameter) {
    const ParameterTypeInfo& info = infoOf(parameter.type);
    if (info.isChoice) {
        for (const EnumValue& value : parameter.values) {
            axis.entries.push_back(value.id);
        }
    } else if (std::holds_alternative<bool>(parameter.defaultValue)) {
        axis.entries = {"false", "true"};
    } else if (isOneNumber(parameter)) {
        axis.range = SheetRange{parameter.softMin, parameter.softMax, usualSheetSteps};
    } else {
        return failure(fmt::format("\"{}\" has no range to go through", axis.value),
                       "a list of its values");
    }
    return {};
}

/// Returns the levels of the accuracy choice, of the material or of the picture, that has this id,
/// and stores its label in `title`. Empty where no choice has this id.
std::vector<SheetStep> levelSteps(const Scene& scene, std::size_t object, const std::string& id,
                                  const Catalog& catalog, std::string& title) {
    std::vector<SheetStep> steps;
    const std::string_view ofPicture = isOfPicture(id) ? std::string_view(id).substr(8) : "";
    if (const PictureChoiceText* choice = pictureChoiceText(ofPicture)) {
        title = choice->label;
        for (const PictureChoiceText::Level& level : choice->levels) {
            steps.push_back({level.id, level.label});
        }
        return steps;
    }
    const Material& material = scene.objects[object].material;
    if (const AccuracyChoice* choice = accuracyChoiceIn(material, id, catalog)) {
        title = choice->label;
        for (const EnumValue& level : choice->values) {
            steps.push_back({level.id, level.label});
        }
    }
    return steps;
}

std::string titleOf(const NamedParameter& named) {
    const Parameter& parameter = *named.parameter;
    const std::string unit = parameter.unit.empty() ? "" : fmt::format(" ({})", parameter.unit);
    return (named.owner.empty() ? "" : named.owner + ": ") + parameter.label + unit;
}

Result<PlannedAxis> plannedLevels(const SheetAxis& axis, const Scene& scene, std::size_t object,
                                  const Catalog& catalog) {
    PlannedAxis planned{axis, axis.value, {}};
    const auto all = levelSteps(scene, object, axis.value, catalog, planned.title);
    if (axis.range && !all.empty()) {
        return failure(fmt::format("\"{}\" is no number to have a range", axis.value),
                       "its levels, or nothing for all of them");
    }
    for (const std::string& entry : axis.entries) {
        const auto found = std::ranges::find(all, entry, &SheetStep::entry);
        planned.steps.push_back(found == all.end() ? SheetStep{entry, entry} : *found);
    }
    if (axis.entries.empty()) {
        planned.steps = all;
    }
    if (planned.steps.empty()) { // nothing has this name: the error says what there is
        Scene tried = scene;
        const auto applied = applyValue(tried, object, axis.value, "0", catalog);
        return applied ? failure("there is nothing to go through")
                       : tl::unexpected(applied.error());
    }
    return planned;
}

Result<PlannedAxis> plannedValue(const SheetAxis& axis, const Scene& scene, std::size_t object,
                                 const Catalog& catalog) {
    const NamedParameter named = parameterOf(scene, object, axis.value, catalog);
    if (named.parameter == nullptr) {
        return plannedLevels(axis, scene, object, catalog);
    }
    const Parameter& parameter = *named.parameter;
    PlannedAxis planned{axis, titleOf(named), {}, isShorthand(parameter)};
    if (!axis.range && axis.entries.empty()) {
        if (const auto chosen = chooseEntries(planned.axis, parameter); !chosen) {
            return tl::unexpected(chosen.error());
        }
    }
    if (planned.axis.range && !isOneNumber(parameter)) {
        return failure(fmt::format("\"{}\" is no number to have a range", axis.value),
                       infoOf(parameter.type).expected(parameter));
    }
    const std::vector<std::string> entries =
        planned.axis.range ? rangeEntries(*planned.axis.range, parameter) : planned.axis.entries;
    for (const std::string& entry : entries) {
        planned.steps.push_back({entry, labelOfValue(&parameter, entry)});
    }
    return planned;
}

// All kinds.

std::string labelOf(const SheetAxis& axis, const Scene& scene, std::size_t object,
                    const std::string& entry, const Catalog& catalog) {
    switch (axis.kind) {
    case AxisKind::Models: {
        const Block* model = catalog.find(kinds::models, entry);
        return model == nullptr ? entry : model->label;
    }
    case AxisKind::Accuracy:
        return labelOfLevels(scene.objects[object].material, entry, catalog);
    case AxisKind::Lights:
        return labelOfLights(scene, entry, catalog);
    case AxisKind::Environments:
        return labelOfEnvironment(entry, catalog);
    case AxisKind::Value:
        break;
    }
    return entry;
}

std::vector<std::string> everyEntry(AxisKind kind, const Scene& scene, std::size_t object,
                                    const Catalog& catalog) {
    switch (kind) {
    case AxisKind::Models:
        return everyBlock(kinds::models, catalog);
    case AxisKind::Accuracy:
        return everyLevel(scene.objects[object].material, catalog);
    case AxisKind::Lights:
        return everyLight(scene, catalog);
    case AxisKind::Environments:
        return everyEnvironment(scene, catalog);
    case AxisKind::Value:
        break;
    }
    return {};
}

/// Holds the title of an axis by its AxisKind.
constexpr std::array<const char*, 5> titles{"Model", "Environment", "Light", "Accuracy", "Value"};

} // namespace

bool isOneNumber(const Parameter& parameter) {
    const ParameterTypeInfo& info = infoOf(parameter.type);
    return info.hasRange && info.components == 1 && !info.isChoice && info.function == nullptr;
}

Result<void> applyStep(Scene& scene, std::size_t object, const SheetAxis& axis,
                       const std::string& entry, const Catalog& catalog) {
    switch (axis.kind) {
    case AxisKind::Models:
        return applyModel(scene, object, entry, catalog);
    case AxisKind::Environments:
        return applyEnvironment(scene, entry, catalog);
    case AxisKind::Lights:
        return applyLights(scene, entry, catalog);
    case AxisKind::Accuracy:
        return applyLevels(scene, object, entry, catalog);
    case AxisKind::Value:
        break;
    }
    return applyValue(scene, object, axis.value, entry, catalog);
}

Result<PlannedAxis> plannedAxis(const SheetAxis& axis, const Scene& scene, std::size_t object,
                                const Catalog& catalog) {
    if (axis.kind == AxisKind::Value) {
        return plannedValue(axis, scene, object, catalog);
    }
    PlannedAxis planned{axis, titles[static_cast<std::size_t>(axis.kind)], {}};
    std::vector<std::string>& entries = planned.axis.entries;
    if (entries.empty()) {
        entries = everyEntry(axis.kind, scene, object, catalog);
        entries.resize(std::min(entries.size(), std::size_t(maxSheetSteps)));
    }
    for (const std::string& entry : entries) {
        planned.steps.push_back({entry, labelOf(axis, scene, object, entry, catalog)});
    }
    return planned;
}

} // namespace patina
