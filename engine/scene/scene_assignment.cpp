// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/scene_assignment.h"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

#include "catalog/settings.h"
#include "catalog/suggestion.h"
#include "catalog/typed_value.h"
#include "material/accuracy_text.h"
#include "material/block_assignment.h"
#include "scene/picture_levels.h"
#include "scene/scene_settings.h"

namespace patina {
namespace {

/// Returns where the first word of an id leads.
std::string firstWord(const std::string& assignment) {
    return assignment.substr(0, assignment.find_first_of(".="));
}

/// Objects inside a scene file whose keys are settings of the scene: "ground", "hemisphere".
bool isGroup(std::string_view word) {
    const auto& parameters = settingsBlock(settings::scene)->parameters;
    return std::ranges::any_of(parameters, [word](const Parameter& parameter) {
        return parameter.id.size() > word.size() && parameter.id.starts_with(word) &&
               parameter.id[word.size()] == '.';
    });
}

bool isSettings(std::string_view word) {
    return word == settings::scene || word == settings::camera || word == settings::object;
}

bool isOfScene(const BlockKind& kind) {
    return kind.owner == BlockOwner::Scene || kind.owner == BlockOwner::Light ||
           kind.folder == kinds::lights;
}

bool hasParameter(const Catalog& catalog, std::string_view kind, std::string_view id) {
    return std::ranges::any_of(
        catalog.ofKind(kind), [id](const Block* block) { return block->parameter(id) != nullptr; });
}

/// Tells whether it is a value of materials alone, whose first word is also that of this kind:
/// "tone.curve".
bool isForMaterial(const Assignment& assignment, const BlockKind& kind, const Catalog& catalog) {
    return !hasParameter(catalog, kind.folder, assignment.inside(kind.singular)) &&
           std::ranges::any_of(blockKinds(), [&](const BlockKind& each) {
               return each.owner == BlockOwner::Material &&
                      hasParameter(catalog, each.folder, assignment.id);
           });
}

tl::unexpected<Error> unknownId(const Assignment& assignment, const std::string& what,
                                const std::vector<std::string>& known) {
    return failure(what + " has no such parameter", oneOf(assignment.id, known));
}

template <class Owner>
Result<void> assignSetting(Owner& owner, std::string_view word, const Assignment& inner) {
    const Block& block = *settingsBlock(word);
    const Parameter* parameter = block.parameter(inner.id);
    if (parameter == nullptr) {
        return unknownId(inner, fmt::format("the {}", word), parameterIds(block));
    }
    return valueFromText(*parameter, inner.text).map([&](const Value& value) {
        storeSetting(owner, inner.id, value);
    });
}

Result<void> assignSettings(Scene& scene, std::string_view word, const Assignment& inner,
                            std::size_t object) {
    if (word == settings::camera) {
        return assignSetting(scene.camera, word, inner);
    }
    if (word == settings::scene) {
        return assignSetting(scene, word, inner);
    }
    if (object >= scene.objects.size()) {
        return failure("the scene has no object");
    }
    return assignSetting(scene.objects[object], word, inner);
}

/// Sets a value of a block that the scene or a light may have; `option` is what would choose one.
Result<void> assignInBlock(const Block* block, BlockValues* values, const Assignment& inner,
                           const std::string& what, const std::string& option) {
    if (block == nullptr || values == nullptr) {
        return failure(what + " is not there", option);
    }
    if (block->accuracyChoice(inner.id) != nullptr && !hasChosenLevels(block->kind)) {
        return failure(fmt::format("no level of {} is chosen: its exact way is drawn", what),
                       oneOf(inner.id, parameterIds(*block)));
    }
    const auto done = assignIn(*block, values->parameters, inner);
    if (!done) {
        return tl::unexpected(done.error());
    }
    return *done ? Result<void>() : unknownId(inner, what, parameterIds(*block));
}

std::string lowered(std::string_view text) {
    std::string lower(text);
    std::ranges::transform(lower, lower.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return lower;
}

/// Sets a value of the light's block, or of what every light has.
Result<void> assignInLight(Light& light, const Block* block, const Assignment& own,
                           const std::string& what) {
    const bool isSetting = settingsBlock(settings::light)->parameter(own.id) != nullptr;
    if (isSetting && (block == nullptr || block->parameter(own.id) == nullptr)) {
        return assignSetting(light, settings::light, own);
    }
    auto done = assignInBlock(block, &light.block, own, what, "--light");
    if (!done && block != nullptr && block->parameter(own.id) == nullptr) {
        std::vector<std::string> known = parameterIds(*block);
        const auto settings = parameterIds(*settingsBlock(settings::light));
        known.insert(known.end(), settings.begin(), settings.end());
        return unknownId(own, what, known);
    }
    return done;
}

/// Returns the light whose name an id is or begins with, the longest of several: "key light.2" is
/// no part of "key light". Null where there is none.
template <class AnyScene>
auto lightIn(AnyScene& scene, const std::string& id) {
    decltype(scene.lights.data()) found = nullptr;
    for (auto& light : scene.lights) {
        const std::string name = lowered(light.name);
        const bool isNamed =
            lowered(id) == name || !Assignment{lowered(id), {}}.inside(name).empty();
        if (isNamed && (found == nullptr || found->name.size() < light.name.size())) {
            found = &light;
        }
    }
    return found;
}

/// Sets "key.intensity": the light's name, and what is set of it.
Result<void> assignInLights(Scene& scene, const Assignment& inner, const Catalog& catalog) {
    Light* light = lightIn(scene, inner.id);
    if (light == nullptr) {
        const std::string name = firstWord(inner.id);
        return failure(fmt::format("there is no light \"{}\"", name), expectedLights(scene, name));
    }
    const std::string what = fmt::format("the light \"{}\"", light->name);
    const Block* block = catalog.find(kinds::lights, light->block.id);
    if (inner.id.size() == light->name.size()) {
        return block == nullptr
                   ? failure(what + " is no value")
                   : failure(what + " is no value", oneOf(inner.id, parameterIds(*block)));
    }
    const Assignment own{inner.id.substr(light->name.size() + 1), inner.text};
    for (const std::string_view kind : partKinds(BlockOwner::Light)) {
        const std::string_view word = findKind(kind)->singular;
        if (const std::string id = own.inside(word); !id.empty()) {
            return assignInBlock(blockOf(light->parts, kind, catalog), light->part(kind),
                                 {id, inner.text}, fmt::format("the {} of {}", word, what),
                                 fmt::format("--{}", word));
        }
    }
    return assignInLight(*light, block, own, what);
}

/// Sets the value in every light that has a part of the kind: "shadow.angle=3".
Result<void> assignInAllLights(Scene& scene, std::string_view kind, const Assignment& inner,
                               const Catalog& catalog) {
    const std::string_view word = findKind(kind)->singular;
    bool isThere = false;
    for (Light& light : scene.lights) {
        if (light.part(kind) == nullptr) {
            continue;
        }
        isThere = true;
        auto done = assignInBlock(blockOf(light.parts, kind, catalog), light.part(kind), inner,
                                  fmt::format("the {} of the light \"{}\"", word, light.name),
                                  fmt::format("--{}", word));
        if (!done) {
            return done;
        }
    }
    return isThere ? Result<void>()
                   : failure(fmt::format("no light has a {}", word), fmt::format("--{}", word));
}

/// Returns the passes that "2.radius", "kuwahara.radius" or "radius" speaks of, and what is left of
/// the id then: that of a place from 1 on, those of a block, or all that have the parameter.
struct NamedPasses {
    std::vector<std::size_t> places;
    std::string id;
};

NamedPasses passesNamed(const Scene& scene, const std::string& id, const Catalog& catalog) {
    const std::string word = firstWord(id);
    NamedPasses named;
    for (std::size_t i = 0; i < scene.passes.size(); ++i) {
        if (word == std::to_string(i + 1) || word == scene.passes[i].id) {
            named.places.push_back(i);
        }
    }
    if (!named.places.empty()) {
        named.id = Assignment{id, {}}.inside(word);
        return named;
    }
    named.id = id;
    for (std::size_t i = 0; i < scene.passes.size(); ++i) {
        const Block* block = catalog.find(kinds::pass, scene.passes[i].id);
        if (block != nullptr && block->parameter(id) != nullptr) {
            named.places.push_back(i);
        }
    }
    return named;
}

/// Sets "pass.radius", "pass.kuwahara.radius" or "pass.2.radius".
Result<void> assignInPasses(Scene& scene, const Assignment& inner, const Catalog& catalog) {
    if (scene.passes.empty()) {
        return failure("the scene has no picture pass", "--pass");
    }
    const NamedPasses named = passesNamed(scene, inner.id, catalog);
    if (named.places.empty()) {
        std::vector<std::string> known;
        for (const BlockValues& pass : scene.passes) {
            known.push_back(pass.id);
        }
        return failure(fmt::format("no picture pass of the scene is or has \"{}\"", inner.id),
                       oneOf(inner.id, known));
    }
    Result<void> done;
    for (const std::size_t place : named.places) {
        BlockValues& pass = scene.passes[place];
        if (done) {
            done = assignInBlock(catalog.find(kinds::pass, pass.id), &pass, {named.id, inner.text},
                                 fmt::format("the pass \"{}\"", pass.id), "--pass");
        }
    }
    return done;
}

/// Finds the parameter in the first pass that an id speaks of.
NamedParameter parameterOfPasses(const Scene& scene, const std::string& id,
                                 const Catalog& catalog) {
    const NamedPasses named = passesNamed(scene, id, catalog);
    const Block* block = named.places.empty()
                             ? nullptr
                             : catalog.find(kinds::pass, scene.passes[named.places.front()].id);
    return block == nullptr ? NamedParameter()
                            : NamedParameter{block->parameter(named.id), block->label};
}

/// Finds the parameter in the first light that has a part of the kind.
NamedParameter parameterOfLights(const Scene& scene, const BlockKind& kind, std::string_view id,
                                 const Catalog& catalog) {
    for (const Light& light : scene.lights) {
        if (const Block* block = blockOf(light.parts, kind.folder, catalog)) {
            return {block->parameter(id), std::string(kind.label)};
        }
    }
    return {};
}

/// Finds "key.intensity", "key.shadow.softness" of the light's block, what every light has, or a
/// part.
NamedParameter parameterOfLight(const Scene& scene, const std::string& id, const Catalog& catalog) {
    const Light* light = lightIn(scene, id);
    if (light == nullptr || light->name.size() == id.size()) {
        return {};
    }
    const Assignment own{id.substr(light->name.size() + 1), {}};
    for (const std::string_view kind : partKinds(BlockOwner::Light)) {
        const Block* part = blockOf(light->parts, kind, catalog);
        const std::string inside = own.inside(findKind(kind)->singular);
        if (part != nullptr && !inside.empty()) {
            return {part->parameter(inside), light->name};
        }
    }
    const Block* block = catalog.find(kinds::lights, light->block.id);
    const Parameter* parameter = block == nullptr ? nullptr : block->parameter(own.id);
    return {parameter != nullptr ? parameter : settingsBlock(settings::light)->parameter(own.id),
            light->name};
}

} // namespace

Light* lightNamed(Scene& scene, std::string_view name) {
    const auto found = std::ranges::find_if(
        scene.lights, [&](const Light& light) { return lowered(light.name) == lowered(name); });
    return found == scene.lights.end() ? nullptr : &*found;
}

std::string expectedLights(const Scene& scene, std::string_view name) {
    std::vector<std::string> names;
    for (const Light& light : scene.lights) {
        names.push_back(lowered(light.name));
    }
    return names.empty() ? "a light, as --light adds it" : oneOf(lowered(name), names);
}

bool isForScene(const std::string& assignment, const Catalog& catalog) {
    const std::string word = firstWord(assignment);
    if (word.size() == assignment.size() || assignment[word.size()] != '.') {
        return false;
    }
    const BlockKind* kind = kindCalled(word);
    if (kind != nullptr && isOfScene(*kind)) {
        const auto cut = assignmentFrom(assignment);
        return !cut || !isForMaterial(*cut, *kind, catalog);
    }
    return isSettings(word) || isGroup(word) || isOfPicture(assignment);
}

Result<void> assignInScene(Scene& scene, const std::string& text, const Catalog& catalog,
                           std::size_t object) {
    const auto assignment = assignmentFrom(text);
    if (!assignment) {
        return tl::unexpected(assignment.error());
    }
    const std::string word = firstWord(text);
    const Assignment inner{assignment->inside(word), assignment->text};
    if (isOfPicture(text)) {
        return choosePictureAccuracy(scene, text);
    }
    if (isSettings(word)) {
        return assignSettings(scene, word, inner, object);
    }
    if (isGroup(word)) {
        return assignSettings(scene, settings::scene, *assignment, object);
    }
    if (word == findKind(kinds::lights)->singular) {
        return assignInLights(scene, inner, catalog);
    }
    const std::string_view kind = kindCalled(word)->folder;
    if (findKind(kind)->owner == BlockOwner::Light) {
        return assignInAllLights(scene, kind, inner, catalog);
    }
    if (findKind(kind)->isInRow) {
        return assignInPasses(scene, inner, catalog);
    }
    return assignInBlock(blockOf(scene.parts, kind, catalog), scene.part(kind), inner,
                         fmt::format("the scene's {}", word), "--" + word);
}

NamedParameter parameterIn(const Scene& scene, std::string_view id, const Catalog& catalog) {
    const Assignment named{std::string(id), {}};
    const std::string word = firstWord(named.id);
    if (isSettings(word)) {
        return {settingsBlock(word)->parameter(named.inside(word))};
    }
    if (isGroup(word)) {
        return {settingsBlock(settings::scene)->parameter(id)};
    }
    const BlockKind* kind = kindCalled(word);
    if (kind != nullptr && kind->folder == kinds::lights) {
        return parameterOfLight(scene, named.inside(word), catalog);
    }
    if (kind != nullptr && kind->owner == BlockOwner::Light) {
        return parameterOfLights(scene, *kind, named.inside(word), catalog);
    }
    if (kind != nullptr && kind->isInRow) {
        return parameterOfPasses(scene, named.inside(word), catalog);
    }
    const Block* block = kind == nullptr ? nullptr : blockOf(scene.parts, kind->folder, catalog);
    return block == nullptr
               ? NamedParameter()
               : NamedParameter{block->parameter(named.inside(word)), std::string(kind->label)};
}

} // namespace patina
