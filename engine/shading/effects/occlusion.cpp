// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/occlusion.h"

#include "shading/effects/effect_set.h"
#include "shading/effects/surface_text.h"

namespace patina {
namespace {

bool isDrawing(const EffectSet& set) {
    return set.model && set.model->block().lighting == LightsWanted::Key;
}

bool hasHiddenLight(const EffectSet& set) {
    return set.ambient || set.hemisphere || set.environment;
}

} // namespace

void OcclusionEffect::choose(const SceneSubject& subject, const EffectSet&) {
    wantsOcclusion = subject.scene.occlusion;
}

void OcclusionEffect::adjust(const EffectSet& set) {
    isOccluded = wantsOcclusion && set.model && !isDrawing(set) && hasHiddenLight(set);
}

void OcclusionEffect::list(EffectListing& listing, const EffectSet&) const {
    if (isOccluded) {
        listing.add("occlusion", {},
                    always("The object hides part of the light from all around from itself."));
    }
}

void OcclusionEffect::listMissing(LeftOutListing& listing, const EffectSet& set) const {
    if (!wantsOcclusion || isOccluded) {
        return;
    }
    if (!hasHiddenLight(set)) {
        listing.add("occlusion", "The scene has no environment and no ambient light.");
    } else if (isDrawing(set)) {
        listing.add("occlusion", "The material is a drawing: its tones say where it is dark.");
    } else {
        listing.add("occlusion", "The object is drawn without its model.");
    }
}

/// First, as what lights a surface asks for it.
void OcclusionEffect::writeLight(SurfaceText& text) const {
    if (isOccluded) {
        text.out.addFile("passes/openness.glsl");
        text.main += "    opened = openness(s);\n";
    }
}

std::string OcclusionEffect::writeVertex(SourceBuilder& vertex) const {
    if (!isOccluded) {
        return {};
    }
    vertex.addFile("passes/openness.vert");
    return "    placeOpenness();\n";
}

void OcclusionEffect::remove(Scene& scene, const EffectName& effect, const Catalog&) {
    if (effect.kind == "occlusion") {
        scene.occlusion = false;
    }
}

bool needsOpenness(const Scene& scene, const Catalog& catalog) {
    const EffectSet set = sceneEffects(scene, catalog);
    return set.wantsOcclusion && hasHiddenLight(set);
}

std::string openFactor(const SurfaceText& text) {
    return text.set.isOccluded ? " * opened.share" : "";
}

void addOpenDirections(SurfaceText& text) {
    if (text.set.isOccluded) {
        text.out.addFile("passes/openness.glsl");
        text.out.addFile("passes/openness_directions.glsl");
        return;
    }
    text.out.add("#define OPEN_TOWARDS(d, width) 1.0\n#define OPEN_SHARE 1.0\n"
                 "#define OPEN_MEAN(n) (n)\n");
}

} // namespace patina
