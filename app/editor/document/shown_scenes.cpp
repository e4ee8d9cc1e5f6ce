// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/shown_scenes.h"

#include <utility>

namespace patina {

const Scene& ShownScenes::scene(const DocumentState& state, int object, Side side) {
    const bool isOwn = side == Side::A && overlaidPicture(state, side) == nullptr;
    if (isOwn || !state.second || object < 0) {
        return state.scene;
    }
    std::optional<Scene>& shown = shown_[static_cast<std::size_t>(side)];
    if (!shown) {
        shown = shownScene(state, object, side);
    }
    return *shown;
}

void ShownScenes::follow(const DocumentState& state, int object, const BlockPath& path,
                         std::string_view parameterId) {
    update(Side::A, state, object, path, parameterId);
    update(Side::B, state, object, path, parameterId);
}

void ShownScenes::update(Side side, const DocumentState& state, int object, const BlockPath& path,
                         std::string_view parameterId) {
    std::optional<Scene>& shown = shown_[static_cast<std::size_t>(side)];
    const std::optional<Value> stored = storedValue(state, path, parameterId);
    if (!shown || !stored) {
        return;
    }
    const bool isOfMaterial = path.owner == BlockOwner::Material;
    const bool isOfB = isOfMaterial && path.side == Side::B;
    if (isOfB && state.picture) {
        shown.reset(); // side B may have its own material from now on
        return;
    }
    const bool isHidden = isOfMaterial && !isOfB && path.index == object && side == Side::B &&
                          hasSecondMaterial(state);
    if (isHidden || (isOfB && side == Side::A)) {
        return;
    }
    BlockPath there = path;
    if (isOfB) {
        there.side = Side::A;
        there.index = object;
    }
    DocumentState changed{std::move(*shown), std::nullopt};
    storeValue(changed, there, parameterId, *stored);
    if (const SidePicture* picture = overlaidPicture(state, side)) {
        layOver(changed.scene, *picture);
    }
    shown = std::move(changed.scene);
}

} // namespace patina
