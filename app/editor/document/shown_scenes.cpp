// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/shown_scenes.h"

#include <utility>

namespace patina {
namespace {

void layOverSide(Scene& shown, const DocumentState& state, Side side) {
    if (const SidePicture* picture = overlaidPicture(state, side)) {
        layOver(shown, *picture);
    }
}

} // namespace

const Scene& ShownScenes::scene(const DocumentState& state, int object, Side side) {
    const bool isOwn = side == Side::A && overlaidPicture(state, side) == nullptr &&
                       ownView(state, side).isLinked();
    if (isOwn || !state.second || object < 0) {
        return state.scene;
    }
    keepFor(object);
    std::optional<Scene>& shown = shown_[indexOf(side)];
    if (!shown) {
        shown = shownScene(state, object, side);
    }
    return *shown;
}

void ShownScenes::follow(const DocumentState& state, int object, const BlockPath& path,
                         std::string_view parameterId) {
    keepFor(object);
    for (const Side side : sides) {
        update(side, state, object, path, parameterId);
    }
}

void ShownScenes::keepFor(int object) {
    if (object_ != object) {
        forget();
        object_ = object;
    }
}

void ShownScenes::update(Side side, const DocumentState& state, int object, const BlockPath& path,
                         std::string_view parameterId) {
    std::optional<Scene>& shown = shown_[indexOf(side)];
    const std::optional<Value> stored = storedValue(state, path, parameterId);
    if (!shown || !stored || (path.isOfView && path.side != side)) {
        return;
    }
    if (path.isOfView) {
        relink(*shown, state.scene, ownView(state, side));
        layOverSide(*shown, state, side);
        return;
    }
    const bool isOfMaterial = path.owner == BlockOwner::Material;
    const bool isOfSide = isOfMaterial && path.side != Side::A;
    if (isOfMaterial && path.side == Side::B && state.picture) {
        shown.reset(); // side B may have its own material from now on
        return;
    }
    const bool isHidden =
        isOfMaterial && !isOfSide && path.index == object && hasOwnMaterial(state, side);
    if (isHidden || (isOfSide && side != path.side)) {
        return;
    }
    BlockPath there = path;
    if (isOfSide) {
        there.side = Side::A;
        there.index = object;
    }
    DocumentState changed{std::move(*shown), std::nullopt};
    storeValue(changed, there, parameterId, *stored);
    if (path.owner == BlockOwner::Scene) {
        giveOwn(changed.scene, ownView(state, side));
    }
    layOverSide(changed.scene, state, side);
    shown = std::move(changed.scene);
}

} // namespace patina
