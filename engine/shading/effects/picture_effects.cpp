// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/picture_effects.h"

#include <algorithm>

#include "shading/effects/highlight_width.h"

namespace patina {
namespace {

/// Null: nothing needs each pixel.
const char* whyPerPixel(const EffectSet& set, const Catalog& catalog) {
    const std::vector<LightGroup>& lights = set.scene.lights;
    if (!set.textures.empty()) {
        return "Lighting stays per pixel: images change the surface between its corners.";
    }
    if (drawsMarks(*catalog.find(kinds::models, set.model->id))) {
        return "Lighting stays per pixel: the model draws marks.";
    }
    if (std::ranges::any_of(lights, [](const LightGroup& group) { return bool(group.shadow); })) {
        return "Lighting stays per pixel: shadows have edges between the corners.";
    }
    if (set.scene.environment) {
        return "Lighting stays per pixel: an environment's light is summed up there.";
    }
    return nullptr;
}

/// Null: nothing needs normals of length 1.
const char* whyUnitNormals(const EffectSet& set) {
    if (set.refraction) {
        return "They have length 1 in a material that bends light.";
    }
    return set.scene.environment ? "They have length 1 under an environment." : nullptr;
}

void addVertexLight(EffectSet& set, const Catalog& catalog) {
    const char* why = whyPerPixel(set, catalog);
    set.lightsAtVertices = why == nullptr;
    if (why != nullptr) {
        set.leftOut.push_back({"vertex lighting", why});
    }
}

/// Light that comes from the vertices needs no normals between them.
void addBlendedNormals(EffectSet& set) {
    const char* why = whyUnitNormals(set);
    set.leavesNormals = why == nullptr && !set.lightsAtVertices;
    if (why != nullptr) {
        set.leftOut.push_back({"blended normals", why});
    }
}

/// A pixel's neighbours say how much the surface turns; vertices have none.
void addWideHighlights(EffectSet& set, const Catalog& catalog) {
    const auto isWidened = [&catalog](const BlockUse& use) {
        return hasHighlightWidth(*catalog.find(use.kind, use.id));
    };
    const bool hasWidth = isWidened(*set.model) || std::ranges::any_of(set.slots, isWidened);
    set.widensHighlights = hasWidth && !set.lightsAtVertices;
    if (!set.widensHighlights) {
        set.leftOut.push_back(
            {"wide highlights", hasWidth ? "Light that is worked out at vertices is not widened."
                                         : "The model has no highlight with a width."});
    }
}

} // namespace

void addPictureEffects(SceneEffects& effects, const Scene& scene) {
    effects.wantsVertexLight = scene.accuracy.lightsAtVertices();
    effects.wantsBlendedNormals = scene.accuracy.leavesNormals();
    effects.wantsWideHighlights = scene.accuracy.widensHighlights();
    effects.fogsAtVertices = effects.fog && scene.accuracy.fogsAtVertices();
}

std::uint64_t pictureEffectsKey(const Scene& scene, bool hasFog) {
    const PictureAccuracy& accuracy = scene.accuracy;
    return (accuracy.lightsAtVertices() ? 1u : 0u) + (accuracy.leavesNormals() ? 2u : 0u) +
           (accuracy.widensHighlights() ? 4u : 0u) +
           (hasFog && accuracy.fogsAtVertices() ? 8u : 0u);
}

void addPictureWork(EffectSet& set, const Catalog& catalog) {
    if (set.model && set.scene.wantsVertexLight) {
        addVertexLight(set, catalog);
    }
    if (set.model && set.scene.wantsBlendedNormals) {
        addBlendedNormals(set);
    }
    if (set.model && set.scene.wantsWideHighlights) {
        addWideHighlights(set, catalog);
    }
}

bool drawsMarks(const Block& model) {
    return std::ranges::any_of(model.parameters,
                               [](const Parameter& parameter) { return parameter.unit == "px"; });
}

} // namespace patina
