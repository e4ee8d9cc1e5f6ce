// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/document_state.h"

#include "document/fixed_blocks.h"

namespace patina {

namespace {

/// `container[index]`, or null when there is none.
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
    auto* found = elementAt(state.scene.objects, object);
    return found ? &found->material : nullptr;
}

template <class Optional>
auto pointer(Optional& optional) -> decltype(&*optional) {
    return optional ? &*optional : nullptr;
}

template <class State>
auto findBlockValues(State& state, const BlockPath& path) -> decltype(pointer(state.scene.fog)) {
    if (path.part == BlockPath::Part::Fog) {
        return pointer(state.scene.fog);
    }
    if (path.part == BlockPath::Part::Environment) {
        return pointer(state.scene.environment);
    }
    if (path.part == BlockPath::Part::Transparency) {
        return pointer(state.scene.transparency);
    }
    if (path.part == BlockPath::Part::Light) {
        auto* light = elementAt(state.scene.lights, path.index);
        return light ? &light->block : nullptr;
    }
    if (path.part == BlockPath::Part::Shadow) {
        auto* light = elementAt(state.scene.lights, path.index);
        return light ? pointer(light->shadow) : nullptr;
    }
    auto* material = findMaterial(state, path.index, path.side);
    if (material && path.part == BlockPath::Part::Model) {
        return &material->model;
    }
    const std::string_view kind = partKind(path.part);
    return material && !kind.empty() ? material->part(kind) : nullptr;
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

const SidePicture* pictureLaidOver(const DocumentState& state, Side side) {
    if (!state.picture || !state.second) {
        return nullptr;
    }
    const auto& picture = side == Side::A ? state.picture->first : state.picture->second;
    return picture ? &*picture : nullptr;
}

Scene shownScene(const DocumentState& state, int object, Side side) {
    Scene scene = ownScene(state, object, side);
    if (const SidePicture* picture = pictureLaidOver(state, side)) {
        layOver(scene, *picture);
    }
    return scene;
}

Scene ownScene(const DocumentState& state, int object, Side side) {
    Scene scene = state.scene;
    if (side == Side::B && hasSecondMaterial(state)) {
        if (Object* shown = elementAt(scene.objects, object)) {
            shown->material = *state.second;
        }
    }
    return scene;
}

std::string_view partKind(BlockPath::Part part) {
    switch (part) {
    case BlockPath::Part::Fresnel:
        return "fresnel";
    case BlockPath::Part::Specular:
        return "specular";
    case BlockPath::Part::Refraction:
        return "refraction";
    case BlockPath::Part::Outline:
        return "outline";
    default:
        return {};
    }
}

const Material* materialAt(const DocumentState& state, int object, Side side) {
    return findMaterial(state, object, side);
}

Material* materialAt(DocumentState& state, int object, Side side) {
    return findMaterial(state, object, side);
}

std::optional<Material> materialAside(const DocumentState& state, int object) {
    const Material* now = materialAt(state, object, Side::A);
    if (!now || !state.lookedAt || state.lookedAt->object != object) {
        return std::nullopt;
    }
    const LookedAt& looked = *state.lookedAt;
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

const BlockValues* blockValuesAt(const DocumentState& state, const BlockPath& path) {
    return findBlockValues(state, path);
}

BlockValues* blockValuesAt(DocumentState& state, const BlockPath& path) {
    return findBlockValues(state, path);
}

std::optional<Value> storedValue(const DocumentState& state, const BlockPath& path,
                                 std::string_view parameterId) {
    if (path.part == BlockPath::Part::Scene) {
        return sceneValue(state.scene, parameterId);
    }
    if (path.part == BlockPath::Part::Object) {
        const Object* object = elementAt(state.scene.objects, path.index);
        return object ? objectValue(*object, parameterId) : std::nullopt;
    }
    if (const BlockValues* block = blockValuesAt(state, path)) {
        return storedInBlock(*block, parameterId);
    }
    const Material* material = materialAt(state, path.index, path.side);
    if (material && path.part == BlockPath::Part::Accuracy) {
        return storedLevel(*material, parameterId);
    }
    if (material && path.part == BlockPath::Part::Material) {
        return materialValue(*material, parameterId);
    }
    return std::nullopt;
}

void storeValue(DocumentState& state, const BlockPath& path, std::string_view parameterId,
                const Value& value) {
    if (path.part == BlockPath::Part::Scene) {
        storeSceneValue(state.scene, parameterId, value);
    } else if (path.part == BlockPath::Part::Object) {
        if (Object* object = elementAt(state.scene.objects, path.index)) {
            storeObjectValue(*object, parameterId, value);
        }
    } else if (BlockValues* block = blockValuesAt(state, path)) {
        block->parameters.insert_or_assign(std::string(parameterId), value);
    } else if (Material* material = materialAt(state, path.index, path.side)) {
        if (path.part == BlockPath::Part::Accuracy && std::holds_alternative<std::string>(value)) {
            material->accuracy.insert_or_assign(std::string(parameterId),
                                                std::get<std::string>(value));
        } else if (path.part == BlockPath::Part::Material) {
            storeMaterialValue(*material, parameterId, value);
        }
    }
}

} // namespace patina
