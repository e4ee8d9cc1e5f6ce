// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/compared_picture.h"

namespace patina {
namespace {

/// Returns the values of `shown` that `own` does not have, or has with another value.
Values otherValues(const Values& shown, const Values& own) {
    Values others;
    for (const auto& [id, value] : shown) {
        const auto found = own.find(id);
        if (found == own.end() || !(found->second == value)) {
            others.emplace(id, value);
        }
    }
    return others;
}

void give(Values& own, const Values& others) {
    for (const auto& [id, value] : others) {
        own[id] = value;
    }
}

} // namespace

SidePicture pictureOf(const Scene& shown, const Scene& own) {
    SidePicture picture{shown.accuracy, std::nullopt, {}, {}, {}};
    const BlockValues* transparency = shown.part(kinds::transparency);
    const BlockValues* ownTransparency = own.part(kinds::transparency);
    if (transparency && !(ownTransparency && *transparency == *ownTransparency)) {
        picture.transparency = *transparency;
    }
    const BlockValues* environment = shown.part(kinds::environment);
    const BlockValues* ownEnvironment = own.part(kinds::environment);
    if (environment && ownEnvironment) {
        picture.environment = otherValues(environment->parameters, ownEnvironment->parameters);
    }
    for (std::size_t i = 0; i < shown.lights.size() && i < own.lights.size(); ++i) {
        const BlockValues* shadow = shown.lights[i].part(kinds::shadows);
        const BlockValues* ownShadow = own.lights[i].part(kinds::shadows);
        if (!shadow || !ownShadow) {
            continue;
        }
        Values others = otherValues(shadow->parameters, ownShadow->parameters);
        if (!others.empty()) {
            picture.shadows[i] = std::move(others);
        }
    }
    for (std::size_t i = 0; i < shown.passes.size() && i < own.passes.size(); ++i) {
        Values others = otherValues(shown.passes[i].parameters, own.passes[i].parameters);
        if (shown.passes[i].id == own.passes[i].id && !others.empty()) {
            picture.passes[i] = std::move(others);
        }
    }
    return picture;
}

void layOver(Scene& scene, const SidePicture& picture) {
    scene.accuracy = picture.accuracy;
    if (scene.part(kinds::transparency) && picture.transparency) {
        scene.setPart(kinds::transparency, picture.transparency);
    }
    if (BlockValues* environment = scene.part(kinds::environment)) {
        give(environment->parameters, picture.environment);
    }
    for (const auto& [light, values] : picture.shadows) {
        const bool isThere = light < scene.lights.size();
        if (BlockValues* shadow = isThere ? scene.lights[light].part(kinds::shadows) : nullptr) {
            give(shadow->parameters, values);
        }
    }
    for (const auto& [pass, values] : picture.passes) {
        if (pass < scene.passes.size()) {
            give(scene.passes[pass].parameters, values);
        }
    }
}

} // namespace patina
