// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/blend.h"

#include <fmt/format.h>

#include "shading/effects/data_layout.h"
#include "shading/effects/effect_set.h"
#include "shading/effects/neutral_values.h"
#include "shading/effects/spectral_range.h"
#include "shading/effects/surface_text.h"

namespace patina {
namespace {

/// Returns the material's Fresnel term, unless its model calls it. A fallback for an unknown model
/// keeps its stripes: blending it would hide them. Where the model was left out, as to see what it
/// does, the blend stays.
const BlockValues* blendedPart(const MaterialSubject& subject, const EffectSet& set) {
    const std::string& model = subject.material.model.id;
    const bool isUnknown = !model.empty() && subject.catalog.find(kinds::models, model) == nullptr;
    const bool isCalled = set.model && set.model->block().slot(kinds::fresnel) != nullptr;
    return isUnknown || isCalled ? nullptr : subject.material.part(kinds::fresnel);
}

} // namespace

void BlendEffect::choose(const MaterialSubject& subject, const EffectSet& set) {
    const BlockValues* part = blendedPart(subject, set);
    const Block* block = part == nullptr ? nullptr : subject.catalog.find(kinds::fresnel, part->id);
    blend.reset();
    if (block != nullptr && !isNeutralPart(*block, part->parameters, subject.material)) {
        blend.emplace(*block, part->parameters, subject.material.accuracy);
    }
}

void BlendEffect::adjust(const EffectSet& set) {
    if (blend) {
        makeTexturedExact(*blend, set);
    }
}

void BlendEffect::list(EffectListing& listing, const EffectSet&) const {
    if (blend) {
        listing.add(*blend, [this](const EffectSubject& subject) {
            const BlockValues* part = subject.material->part(kinds::fresnel);
            return "The material has a Fresnel term and the model has no slot for it." +
                   (part == nullptr
                        ? std::string()
                        : spectralRangeNote(blend->block(), part->parameters, subject.scene));
        });
    }
}

void BlendEffect::listMissing(LeftOutListing& listing, const EffectSet& set) const {
    const Material* material = listing.subject().material;
    const BlockValues* part =
        material == nullptr ? nullptr : blendedPart({*material, listing.subject().catalog}, set);
    if (part == nullptr || blend) {
        return;
    }
    if (const Block* block = listing.subject().catalog.find(kinds::fresnel, part->id)) {
        listing.add(effectName(kinds::fresnel, part->id),
                    whyNeutral(*block, part->parameters, material->accuracy));
    } else {
        listing.add(std::string(kinds::fresnel),
                    fmt::format("No Fresnel term \"{}\" is known.", part->id));
    }
}

void BlendEffect::place(ObjectLayout& layout, const EffectSet&) const {
    if (blend) {
        layout.parts.push_back(placed(*blend, layout.vec4s));
        layout.tables.add(layout.parts.back(), *blend, TableReader::Blend);
    }
}

void BlendEffect::write(SurfaceText& text) const {
    if (!blend) {
        return;
    }
    const Block& block = blend->block();
    text.readFrom("objectData");
    text.addBlock(block);
    text.addUnpack(*blend, "unpackBlend");
    const std::string function = functionName(block);
    const char* share =
        text.isInspected() ? "blendShare(i, p) lookedShare({}(i, p))" : "blendShare {}";
    text.out.add(fmt::format("#define Blend {}\n#define {}\n#define blendTint {}Tint\n",
                             structName(block), fmt::format(fmt::runtime(share), function),
                             function));
    text.out.addFile("passes/fresnel_blend.glsl");
    text.main +=
        fmt::format("    Blend blend = unpackBlend({});\n", text.object.part(block.kind)->first);
    text.main += text.textures.values(block.kind, "blend");
    text.main += "    shaded = fresnelBlended(s, shaded, blend);\n";
    if (text.isInspected()) {
        text.main += "    fresnelTerm = vec4(vec3(blendShare(incidenceBetween(s.n, s.v), blend)), "
                     "1.0);\n";
    }
    text.noteTerm("BLENDED", "shaded", "share");
}

/// Removes the term that a model calls, too.
void BlendEffect::remove(Scene& scene, const EffectName& effect, const Catalog&) {
    if (effect.kind == kinds::fresnel) {
        removePart(scene, effect);
    }
}

} // namespace patina
