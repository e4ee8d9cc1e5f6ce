// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/occlusion.h"

#include <fmt/format.h>

#include "shading/effects/effect_set.h"
#include "shading/effects/surface_buffer_layout.h"
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

/// Comes before all light from around, which it dims.
void OcclusionEffect::writeLight(SurfaceText& text) const {
    if (isOccluded) {
        text.out.addFile("passes/openness.glsl");
        text.main += "    opened = openness(s);\n";
        if (text.isInspected()) {
            text.main += "    opennessTerm = vec4(vec3(opened.share), 1.0);\n";
        }
        text.around = {"facingOpen(s)", " * opened.share", "passes/openness_directions.glsl"};
    }
}

std::string_view OcclusionEffect::whyPerPixel(const EffectSet&) const {
    return isOccluded ? "which side is seen says what the object hides." : std::string_view();
}

/// Stores how the free directions lie off the mesh's normal, and their share.
void OcclusionEffect::writeBuffer(SurfaceText& text, std::size_t place) const {
    if (isOccluded) {
        writeLight(text);
        text.main += fmt::format("    noteValue({}, vec4(opened.direction - opened.normal, "
                                 "opened.share));\n",
                                 place);
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

std::optional<std::size_t> opennessValue(const EffectSet& set) {
    return set.isOccluded ? std::optional(bufferPlace<OcclusionEffect>(set)) : std::nullopt;
}

} // namespace patina
