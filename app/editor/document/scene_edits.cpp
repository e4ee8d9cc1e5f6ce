// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/scene_edits.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include <glm/trigonometric.hpp>

#include "document/commands/bookmark_command.h"
#include "document/commands/group_command.h"
#include "document/commands/light_command.h"
#include "document/commands/lighting_command.h"
#include "document/commands/object_command.h"
#include "document/commands/passes_command.h"
#include "document/commands/scene_block_command.h"
#include "document/compare_edits.h"
#include "document/swapped_block.h"
#include "scene/environment.h"
#include "text/counted.h"

namespace patina {
namespace {

/// Returns the parameter for the direction in which the light of a block travels; null where the
/// block has none.
const Parameter* directionOf(const Block& block) {
    const auto found = std::ranges::find_if(block.parameters, [](const Parameter& parameter) {
        return parameter.space == Space::WorldDirection;
    });
    return found == block.parameters.end() ? nullptr : &*found;
}

template <class Element>
const Element* at(const std::vector<Element>& list, int index) {
    const bool isInside = index >= 0 && index < static_cast<int>(list.size());
    return isInside ? &list[static_cast<std::size_t>(index)] : nullptr;
}

/// Returns the first kind of light from very far away whose colour and brightness can be set; null
/// where there is none.
const Block* farLight(const Catalog& catalog) {
    const std::vector<const Block*> all = catalog.ofKind(kinds::lights);
    const auto found = std::ranges::find_if(all, [](const Block* block) {
        return block->shadowProjection == ShadowProjection::Parallel &&
               block->withRole(roles::color) != nullptr &&
               block->withRole(roles::intensity) != nullptr && directionOf(*block) != nullptr;
    });
    return found == all.end() ? nullptr : *found;
}

/// Returns the first kind of shadows for lamps with a size; null where there is none.
const Block* softShadows(const Catalog& catalog) {
    const std::vector<const Block*> all = catalog.ofKind(kinds::shadows);
    const auto found = std::ranges::find_if(
        all, [](const Block* block) { return block->withRole(roles::angle) != nullptr; });
    return found == all.end() ? nullptr : *found;
}

/// Returns a light in place of a lamp of an environment. `direction` points towards the lamp, in
/// world space.
Light lightOf(const EnvironmentLamp& lamp, const glm::dvec3& direction, const Block& block,
              const Block* shadows) {
    Light light{{}, true, defaultsOf(block)};
    Values& values = light.block.parameters;
    const Parameter& intensity = *block.withRole(roles::intensity);
    const double brightest = std::max({lamp.radiance.r, lamp.radiance.g, lamp.radiance.b, 1e-12});
    values[block.withRole(roles::color)->id] = roundedToFloat(Value(lamp.radiance / brightest));
    values[intensity.id] =
        roundedToFloat(Value(std::clamp(brightest, intensity.min, intensity.max)));
    values[directionOf(block)->id] = roundedToFloat(Value(-direction));
    if (shadows != nullptr) {
        BlockValues soft = defaultsOf(*shadows);
        const Parameter& angle = *shadows->withRole(roles::angle);
        soft.parameters[angle.id] =
            roundedToFloat(Value(std::clamp(glm::degrees(lamp.width), angle.min, angle.max)));
        light.setPart(kinds::shadows, std::move(soft));
    }
    return light;
}

using Names = std::set<std::string, std::less<>>;

Names namesOf(const Scene& scene, std::string Object::*which) {
    Names names;
    for (const Object& object : scene.objects) {
        names.insert(object.*which);
    }
    return names;
}

/// Returns the name if it is free, or else the first free one of "name 2", "name 3" ..., with which
/// a number at its end is replaced.
std::string unusedName(const Names& taken, const std::string& name) {
    const std::size_t letters = name.find_last_not_of("0123456789");
    const bool isNumbered = letters != std::string::npos && letters + 1 < name.size() &&
                            name[letters] == ' ' && letters > 0;
    const std::string stem = isNumbered ? name.substr(0, letters) : name;
    std::string free = name;
    for (int number = 2; taken.contains(free); ++number) {
        free = stem + ' ' + std::to_string(number);
    }
    return free;
}

/// Returns the objects, with names and groups changed to ones that no object of the scene has.
std::vector<Object> namedApart(const Scene& scene, std::vector<Object> objects) {
    Names names = namesOf(scene, &Object::name);
    Names groups = namesOf(scene, &Object::group);
    std::map<std::string, std::string> renamed{{"", ""}};
    for (Object& object : objects) {
        object.name = unusedName(names, object.name);
        names.insert(object.name);
        if (!renamed.contains(object.group)) {
            const std::string group = unusedName(groups, object.group);
            groups.insert(group);
            renamed.emplace(object.group, group);
        }
        object.group = renamed.at(object.group);
    }
    return objects;
}

} // namespace

bool takeLampsOut(Document& document, const EnvironmentLamps& lamps) {
    const Catalog& catalog = document.catalog();
    const Block* environment = blockOf(document.scene().parts, kinds::environment, catalog);
    const Parameter* limit = environment ? environment->withRole(roles::limit) : nullptr;
    const Block* light = farLight(catalog);
    if (limit == nullptr || light == nullptr || lamps.lamps.empty()) {
        return false;
    }
    Scene after = document.scene();
    BlockValues& values = *after.part(kinds::environment);
    values.parameters[limit->id] = roundedToFloat(Value(lamps.limit));
    const double turn = glm::radians(environmentNumber(values, *environment, roles::rotate));
    for (const EnvironmentLamp& lamp : lamps.lamps) {
        const glm::dvec3& d = lamp.direction; // as in shaders/passes/environment.glsl
        const glm::dvec3 outside(std::cos(turn) * d.x + std::sin(turn) * d.z, d.y,
                                 std::cos(turn) * d.z - std::sin(turn) * d.x);
        after.lights.push_back(lightOf(lamp, outside, *light, softShadows(catalog)));
        after.lights.back().name = Document::tr("Lamp of %1")
                                       .arg(QString::fromStdString(environment->label))
                                       .toStdString();
    }
    document.undoStack().push(
        new LightingCommand(document, std::move(after), Document::tr("Take lamps out")));
    return true;
}

void addLight(Document& document, std::string_view blockId) {
    const Block* block = document.catalog().find(kinds::lights, blockId);
    if (!block) {
        return;
    }
    const int index = static_cast<int>(document.scene().lights.size());
    const Light light{block->label, true, defaultsOf(*block)};
    document.undoStack().push(
        new LightCommand(document, index, std::nullopt, light,
                         Document::tr("Add %1").arg(QString::fromStdString(block->label))));
}

void addLights(Document& document, const std::vector<Light>& lights, const QString& label) {
    int index = static_cast<int>(document.scene().lights.size());
    bool hasKey = std::ranges::any_of(document.scene().lights, &Light::isKey);
    GroupCommand::Edits edits;
    for (const Light& each : lights) {
        Light light = each;
        light.isKey = light.isKey && !std::exchange(hasKey, hasKey || light.isKey);
        light.enabled = light.enabled || light.isMutedBySolo;
        light.isMutedBySolo = false;
        edits.push_back(
            std::make_unique<LightCommand>(document, index++, std::nullopt, light, label));
    }
    pushAsOne(document, label, std::move(edits));
}

void setLight(Document& document, int index, const Light& light) {
    const Light* held = at(document.scene().lights, index);
    if (held && !(*held == light)) {
        document.undoStack().push(
            new LightCommand(document, index, *held, light, Document::tr("Change light")));
    }
}

void removeLight(Document& document, int index) {
    if (const Light* held = at(document.scene().lights, index)) {
        document.undoStack().push(
            new LightCommand(document, index, *held, std::nullopt, Document::tr("Remove light")));
    }
}

/// Keeps which lights were on before in the lights themselves, so that it is undone and saved with
/// the scene.
void toggleSolo(Document& document, int index) {
    const std::vector<Light>& lights = document.scene().lights;
    if (!at(lights, index)) {
        return;
    }
    const bool isSolo = std::ranges::any_of(lights, &Light::isMutedBySolo) &&
                        lights[static_cast<std::size_t>(index)].enabled;
    const QString label = isSolo ? Document::tr("End solo") : Document::tr("Solo light");
    GroupCommand::Edits edits;
    for (int i = 0; i < static_cast<int>(lights.size()); ++i) {
        const Light& held = lights[static_cast<std::size_t>(i)];
        Light light = held;
        const bool wasOn = held.enabled || held.isMutedBySolo;
        light.enabled = isSolo ? wasOn : i == index;
        light.isMutedBySolo = !isSolo && i != index && wasOn;
        if (!(light == held)) {
            edits.push_back(std::make_unique<LightCommand>(document, i, held, light, label));
        }
    }
    pushAsOne(document, label, std::move(edits));
}

void toggleMute(Document& document, int index) {
    if (const Light* held = at(document.scene().lights, index)) {
        Light light = *held;
        light.enabled = !held->enabled;
        light.isMutedBySolo = false;
        document.undoStack().push(new LightCommand(document, index, *held, light,
                                                   light.enabled ? Document::tr("Light on")
                                                                 : Document::tr("Mute light")));
    }
}

void addObject(Document& document, const Object& object) {
    const int index = static_cast<int>(document.scene().objects.size());
    document.undoStack().push(
        new ObjectCommand(document, index, std::nullopt, object,
                          Document::tr("Add %1").arg(QString::fromStdString(object.name))));
}

void setObject(Document& document, int index, const Object& object) {
    const Object* held = at(document.scene().objects, index);
    if (held && !(*held == object)) {
        document.undoStack().push(
            new ObjectCommand(document, index, *held, object, Document::tr("Change object")));
    }
}

void setObjects(Document& document, const std::map<int, Object>& objects, const QString& label) {
    bool isChange = false;
    GroupCommand::Edits edits; // also of objects that stay: the steps of a drag merge
    for (const auto& [index, object] : objects) {
        if (const Object* held = at(document.scene().objects, index)) {
            isChange |= !(*held == object);
            edits.push_back(std::make_unique<ObjectCommand>(document, index, *held, object, label));
        }
    }
    if (isChange) {
        pushAsOne(document, label, std::move(edits));
    }
}

void changeObjects(Document& document, const std::vector<int>& indices, const QString& label,
                   const std::function<void(Object&)>& change) {
    std::map<int, Object> changed;
    for (const int index : indices) {
        if (const Object* held = at(document.scene().objects, index)) {
            Object object = *held;
            change(object);
            changed.emplace(index, std::move(object));
        }
    }
    setObjects(document, changed, label);
}

/// Removes the last one first, so that the indices of the others stay right.
void removeObjects(Document& document, std::vector<int> indices) {
    std::ranges::sort(indices, std::greater());
    const QString label =
        counted(indices.size(), Document::tr("Remove object"), Document::tr("Remove %1 objects"));
    GroupCommand::Edits edits;
    for (const int index : indices) {
        if (const Object* held = at(document.scene().objects, index)) {
            edits.push_back(
                std::make_unique<ObjectCommand>(document, index, *held, std::nullopt, label));
        }
    }
    pushAsOne(document, label, std::move(edits));
}

void addObjects(Document& document, const std::vector<Object>& objects, const QString& label) {
    const int first = static_cast<int>(document.scene().objects.size());
    GroupCommand::Edits edits;
    std::vector<int> added;
    for (const Object& object : namedApart(document.scene(), objects)) {
        added.push_back(first + static_cast<int>(added.size()));
        edits.push_back(
            std::make_unique<ObjectCommand>(document, added.back(), std::nullopt, object, label));
    }
    pushAsOne(document, label, std::move(edits));
    document.selection().setObjects(added);
}

std::vector<int> withGroups(const Scene& scene, const std::vector<int>& indices) {
    std::set<std::string> groups;
    std::set<int> all(indices.begin(), indices.end());
    for (const int index : indices) {
        const Object* object = at(scene.objects, index);
        if (object && !object->group.empty()) {
            groups.insert(object->group);
        }
    }
    for (int i = 0; i < static_cast<int>(scene.objects.size()); ++i) {
        if (groups.contains(scene.objects[static_cast<std::size_t>(i)].group)) {
            all.insert(i);
        }
    }
    return {all.begin(), all.end()};
}

void groupObjects(Document& document, const std::vector<int>& indices) {
    const std::string name = unusedName(namesOf(document.scene(), &Object::group),
                                        Document::tr("Group 1").toStdString());
    changeObjects(
        document, indices,
        counted(indices.size(), Document::tr("Group object"), Document::tr("Group %1 objects")),
        [&](Object& object) { object.group = name; });
}

void ungroupObjects(Document& document, const std::vector<int>& indices) {
    changeObjects(
        document, indices,
        counted(indices.size(), Document::tr("Ungroup object"), Document::tr("Ungroup %1 objects")),
        [](Object& object) { object.group.clear(); });
}

void setBookmark(Document& document, int digit, const Camera& camera) {
    const auto found = document.scene().bookmarks.find(digit);
    if (found == document.scene().bookmarks.end() || found->second != camera) {
        document.undoStack().push(new BookmarkCommand(document, digit, camera));
    }
}

void addPass(Document& document, std::string_view blockId) {
    const Block* block = document.catalog().find(kinds::pass, blockId);
    if (!block) {
        return;
    }
    std::vector<BlockValues> passes = document.scene().passes;
    passes.push_back(defaultsOf(*block));
    document.undoStack().push(
        new PassesCommand(document, std::move(passes),
                          Document::tr("Add %1").arg(QString::fromStdString(block->label))));
}

void removePass(Document& document, int index) {
    std::vector<BlockValues> passes = document.scene().passes;
    if (at(passes, index)) {
        passes.erase(passes.begin() + index);
        document.undoStack().push(
            new PassesCommand(document, std::move(passes), Document::tr("Remove picture pass")));
    }
}

void movePass(Document& document, int index, int to) {
    std::vector<BlockValues> passes = document.scene().passes;
    if (at(passes, index) && at(passes, to) && index != to) {
        const auto from = passes.begin() + index;
        const auto place = passes.begin() + to;
        index < to ? std::rotate(from, from + 1, place + 1) : std::rotate(place, from, from + 1);
        document.undoStack().push(
            new PassesCommand(document, std::move(passes), Document::tr("Move picture pass")));
    }
}

void setLighting(Document& document, const Scene& from) {
    document.undoStack().push(new LightingCommand(document, from));
}

std::string_view environmentPicture(const Document& document, Side side) {
    const BlockPath path = environmentPath(document.state(), side);
    const BlockValues* held = blockValuesAt(document.state(), path);
    const Block* block = document.block(path);
    return block ? pictureFile(*held, *block) : std::string_view();
}

std::set<std::string, std::less<>> environmentPictures(const Document& document) {
    std::set<std::string, std::less<>> files;
    for (std::size_t i = 0; i < document.shownSides(); ++i) {
        files.emplace(environmentPicture(document, sides[i]));
    }
    return files;
}

void setEnvironmentPicture(Document& document, const std::filesystem::path& file) {
    Q_EMIT document.fileNamed(file);
    const BlockPath path = document.selection().currentPath(kinds::environment);
    const BlockValues* held = blockValuesAt(document.state(), path);
    const Block* current = document.block(path);
    const std::vector<const Block*> all = document.catalog().ofKind(path.kind);
    const auto found = std::find_if(all.begin(), all.end(), [](const Block* block) {
        return pictureParameter(*block) != nullptr;
    });
    const bool fits = current && pictureParameter(*current);
    const Block* wanted = fits ? current : found == all.end() ? nullptr : *found;
    if (!wanted) {
        return;
    }
    BlockValues after = fits ? *held : defaultsOf(*wanted);
    after.parameters[pictureParameter(*wanted)->id] = file.generic_string();
    if (held && *held == after) {
        return;
    }
    const QString label =
        Document::tr("Environment %1").arg(QString::fromStdString(file.filename().string()));
    if (path.isOfView) {
        OwnView own = ownView(document.state(), path.side);
        own.environment = std::move(after);
        setOwnView(document, path.side, own, label);
    } else {
        document.undoStack().push(new SceneBlockCommand(document, path, after, label));
    }
}

} // namespace patina
