// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/document_state.h"

#include "document/picture_parameters.h"
#include "material/material_settings.h"
#include "material/reconciled.h"
#include "scene/scene_settings.h"

namespace patina {

namespace {

/// Returns the address of `container[index]`, or null when there is no such element.
template <class Container>
auto elementAt(Container& container, int index) -> decltype(&container[0]) {
    const bool inside = index >= 0 && index < static_cast<int>(container.size());
    return inside ? &container[static_cast<std::size_t>(index)] : nullptr;
}

template <class State>
auto findMaterial(State& state, int object, Side side) -> decltype(&*state.second) {
    if (side == Side::B) {
        return state.second ? &*state.second : nullptr;
    }
    if (side != Side::A) {
        return elementAt(state.further, static_cast<int>(indexOf(side) - indexOf(Side::C)));
    }
    auto* found = elementAt(state.scene.objects, object);
    return found ? &found->material : nullptr;
}

template <class Light>
auto findInLight(Light& light, std::string_view kind) -> decltype(&light.block) {
    return kind == kinds::lights ? &light.block : light.part(kind);
}

template <class Material>
auto findInMaterial(Material& material, std::string_view kind) -> decltype(&material.model) {
    return kind == kinds::models ? &material.model : material.part(kind);
}

template <class State>
auto findBlockValues(State& state, const BlockPath& path) -> decltype(state.scene.part(path.kind)) {
    if (path.isOfView) {
        auto& own = state.ownViews[indexOf(path.side)];
        return path.isAt(kinds::environment) && own.environment ? &*own.environment : nullptr;
    }
    if (path.isAt(kinds::pass)) {
        return elementAt(state.scene.passes, path.index);
    }
    if (path.owner == BlockOwner::Scene) {
        return state.scene.part(path.kind);
    }
    if (path.owner == BlockOwner::Light) {
        auto* light = elementAt(state.scene.lights, path.index);
        return light ? findInLight(*light, path.kind) : nullptr;
    }
    auto* material =
        path.owner == BlockOwner::Material ? findMaterial(state, path.index, path.side) : nullptr;
    return material ? findInMaterial(*material, path.kind) : nullptr;
}

/// Returns what owns the settings of this name.
BlockOwner ownerOfSettings(std::string_view word) {
    return word == settings::scene || word == settings::camera ? BlockOwner::Scene
           : word == settings::object                          ? BlockOwner::Object
                                                               : BlockOwner::Material;
}

void reconcileParts(BlockParts& parts, const Catalog& before, const Catalog& after) {
    for (auto& [kind, values] : parts) {
        values = reconciled(values, kind, before, after);
    }
}

std::optional<Value> storedLevel(const Material& material, std::string_view choice) {
    const auto found = material.accuracy.find(choice);
    return found == material.accuracy.end() ? std::nullopt : std::optional<Value>(found->second);
}

std::optional<Value> storedInBlock(const BlockValues& block, std::string_view parameterId) {
    const auto found = block.parameters.find(parameterId);
    return found == block.parameters.end() ? std::nullopt : std::optional<Value>(found->second);
}

} // namespace

bool hasSecondMaterial(const DocumentState& state) {
    return state.second && !(state.picture && state.picture->material == *state.second);
}

bool hasOwnMaterial(const DocumentState& state, Side side) {
    return side == Side::B ? hasSecondMaterial(state)
                           : side != Side::A && indexOf(side) < shownSides(state);
}

std::size_t shownSides(const DocumentState& state) {
    return state.second ? indexOf(Side::C) + state.further.size() : 1;
}

const SidePicture* overlaidPicture(const DocumentState& state, Side side) {
    if (!state.picture || !state.second || indexOf(side) > indexOf(Side::B)) {
        return nullptr;
    }
    const auto& picture = side == Side::A ? state.picture->first : state.picture->second;
    return picture ? &*picture : nullptr;
}

bool isOverlaid(const DocumentState& state, const BlockPath& path, std::string_view parameterId) {
    const SidePicture* picture = overlaidPicture(state, Side::A);
    if (picture == nullptr) {
        return false;
    }
    if (path.isAt(settings::scene)) {
        return pictureLevel(state.scene, parameterId).has_value();
    }
    if (path.isAt(kinds::transparency)) {
        return picture->transparency.has_value();
    }
    if (path.isAt(kinds::environment)) {
        return picture->environment.contains(parameterId);
    }
    const auto values = picture->shadows.find(static_cast<std::size_t>(path.index));
    return path.isAt(kinds::shadows) && values != picture->shadows.end() &&
           values->second.contains(parameterId);
}

Scene shownScene(const DocumentState& state, int object, Side side) {
    Scene scene = ownScene(state, object, side);
    if (const SidePicture* picture = overlaidPicture(state, side)) {
        layOver(scene, *picture);
    }
    return scene;
}

const OwnView& ownView(const DocumentState& state, Side side) {
    static const OwnView linked;
    return state.second && indexOf(side) < shownSides(state) ? state.ownViews[indexOf(side)]
                                                             : linked;
}

BlockPath environmentPath(const DocumentState& state, Side side) {
    BlockPath path = pathOf(kinds::environment);
    if (ownView(state, side).hasEnvironment) {
        path.side = side;
        path.isOfView = true;
    }
    return path;
}

Scene ownScene(const DocumentState& state, int object, Side side) {
    Scene scene = state.scene;
    giveOwn(scene, ownView(state, side));
    if (hasOwnMaterial(state, side)) {
        if (Object* shown = elementAt(scene.objects, object)) {
            shown->material = *materialAt(state, object, side);
        }
    }
    return scene;
}

BlockPath pathOf(std::string_view kind, int index, Side side) {
    const BlockKind* row = findKind(kind);
    return {row ? row->owner : ownerOfSettings(kind), std::string(kind), index, side};
}

const Material* materialAt(const DocumentState& state, int object, Side side) {
    return findMaterial(state, object, side);
}

Material* materialAt(DocumentState& state, int object, Side side) {
    return findMaterial(state, object, side);
}

std::optional<Material> materialAside(const DocumentState& state, int object) {
    const Material* now = materialAt(state, object, Side::A);
    if (!now || !state.preview || state.preview->object != object) {
        return std::nullopt;
    }
    const MaterialPreview& looked = *state.preview;
    if (*now == looked.shown) {
        return looked.own;
    }
    Material likeShown = looked.own;
    likeShown.accuracy = looked.shown.accuracy;
    if (!(likeShown == looked.shown) || now->accuracy != looked.shown.accuracy) {
        return std::nullopt; // what it shows was made its own
    }
    Material own = *now;
    own.accuracy = looked.own.accuracy;
    return own;
}

std::string textureKey(const BlockPath& path, std::string_view parameterId) {
    const BlockKind* kind = findKind(path.kind);
    return kind && kind->isPart ? path.kind + '.' + std::string(parameterId)
                                : std::string(parameterId);
}

bool takesTextures(const BlockPath& path) {
    return path.owner == BlockOwner::Material && !path.isAt(settings::accuracy);
}

const BlockValues* blockValuesAt(const DocumentState& state, const BlockPath& path) {
    return findBlockValues(state, path);
}

BlockValues* blockValuesAt(DocumentState& state, const BlockPath& path) {
    return findBlockValues(state, path);
}

BlockParts* scenePartsAt(DocumentState& state, const BlockPath& path) {
    if (path.owner == BlockOwner::Light) {
        Light* light = elementAt(state.scene.lights, path.index);
        return light ? &light->parts : nullptr;
    }
    const bool isOfScene = path.owner == BlockOwner::Scene && !path.isAt(kinds::pass);
    return isOfScene ? &state.scene.parts : nullptr;
}

std::optional<Value> storedValue(const DocumentState& state, const BlockPath& path,
                                 std::string_view parameterId) {
    if (path.isOfView && path.isAt(settings::scene)) {
        const auto own = settingOf(state.ownViews[indexOf(path.side)], parameterId);
        return own ? own : settingOf(state.scene, parameterId);
    }
    if (path.isAt(settings::scene)) {
        const std::optional<Value> level = pictureLevel(state.scene, parameterId);
        return level ? level : settingOf(state.scene, parameterId);
    }
    if (path.isAt(settings::camera)) {
        return settingOf(state.scene.camera, parameterId);
    }
    if (path.isAt(settings::object)) {
        const Object* object = elementAt(state.scene.objects, path.index);
        return object ? settingOf(*object, parameterId) : std::nullopt;
    }
    if (const BlockValues* block = blockValuesAt(state, path)) {
        return storedInBlock(*block, parameterId);
    }
    const bool isOfMaterial = path.owner == BlockOwner::Material;
    const Material* material = isOfMaterial ? materialAt(state, path.index, path.side) : nullptr;
    if (material && path.isAt(settings::accuracy)) {
        return storedLevel(*material, parameterId);
    }
    if (material && path.isAt(settings::material)) {
        return settingOf(*material, parameterId);
    }
    return std::nullopt;
}

void storeValue(DocumentState& state, const BlockPath& path, std::string_view parameterId,
                const Value& value) {
    if (path.isOfView && path.isAt(settings::scene)) {
        storeSetting(state.ownViews[indexOf(path.side)], parameterId, value);
    } else if (path.isAt(settings::scene)) {
        storeSetting(state.scene, parameterId, value);
        storePictureLevel(state.scene, parameterId, value);
    } else if (path.isAt(settings::camera)) {
        storeSetting(state.scene.camera, parameterId, value);
    } else if (path.isAt(settings::object)) {
        if (Object* object = elementAt(state.scene.objects, path.index)) {
            storeSetting(*object, parameterId, value);
        }
    } else if (BlockValues* block = blockValuesAt(state, path)) {
        block->parameters.insert_or_assign(std::string(parameterId), value);
    } else if (Material* material = materialAt(state, path.index, path.side)) {
        if (path.isAt(settings::accuracy) && std::holds_alternative<std::string>(value)) {
            material->accuracy.insert_or_assign(std::string(parameterId),
                                                std::get<std::string>(value));
        } else if (path.isAt(settings::material)) {
            storeSetting(*material, parameterId, value);
        }
    }
}

void reconcile(DocumentState& state, const Catalog& before, const Catalog& after) {
    for (Object& object : state.scene.objects) {
        object.material = reconciled(object.material, before, after);
    }
    if (state.second) {
        state.second = reconciled(*state.second, before, after);
    }
    for (Material& material : state.further) {
        material = reconciled(material, before, after);
    }
    for (OwnView& own : state.ownViews) {
        if (own.environment) {
            own.environment = reconciled(*own.environment, kinds::environment, before, after);
        }
    }
    for (Snapshot& snapshot : state.snapshots) {
        snapshot.material = reconciled(snapshot.material, before, after);
    }
    if (state.picture) {
        state.picture->material = reconciled(state.picture->material, before, after);
    }
    for (Light& light : state.scene.lights) {
        light.block = reconciled(light.block, kinds::lights, before, after);
        reconcileParts(light.parts, before, after);
    }
    reconcileParts(state.scene.parts, before, after);
    for (BlockValues& pass : state.scene.passes) {
        pass = reconciled(pass, kinds::pass, before, after);
    }
}

} // namespace patina
