// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/tone_effect.h"

#include <fmt/format.h>

#include "shading/program/block_source.h"

namespace patina {

void ToneEffect::choose(const Scene& scene, const Catalog& catalog) {
    const BlockValues* part = scene.part(kinds::tone);
    const Block* block = part == nullptr ? nullptr : catalog.find(kinds::tone, part->id);
    tone.reset();
    if (block != nullptr) {
        tone.emplace(*block, part->parameters);
    }
}

void ToneEffect::list(EffectListing& listing, const DisplaySet&) const {
    if (tone) {
        listing.add(*tone, always("What is too bright for a display is compressed. What is above 1 "
                                  "behind the curve is cut off."));
    }
}

void ToneEffect::listMissing(LeftOutListing& listing, const DisplaySet&) const {
    if (tone) {
        return;
    }
    if (const BlockValues* part = listing.subject().scene.part(kinds::tone)) {
        listing.add(effectName(kinds::tone, part->id),
                    fmt::format("No tone curve \"{}\" is known.", part->id));
    } else {
        listing.add(std::string(kinds::tone), "None is chosen: what is above 1 is cut off.");
    }
}

void ToneEffect::write(SourceBuilder& fragment) const {
    if (!tone) {
        fragment.add("#define toneMapped(light) (light)\n");
        return;
    }
    const Block& block = tone->block();
    const int vec4s = vec4Count(block);
    if (vec4s > 0) {
        fragment.add(fmt::format("uniform vec4 toneData[{}];\n", vec4s));
    }
    fragment.add(unpackedFrom("toneData"));
    fragment.add(constantsSource(block) + structSource(block, tone->compiled()));
    fragment.addBlock(block);
    fragment.add(unpackSource(block, {"unpackTone", tone->compiled()}));
    fragment.add(
        fmt::format("vec3 toneMapped(vec3 light) {{\n    return {}(light, unpackTone(0));\n}}\n",
                    functionName(block)));
}

void ToneEffect::remove(Scene& scene, const EffectName& effect, const Catalog&) {
    if (effect.kind == kinds::tone) {
        scene.setPart(kinds::tone, std::nullopt);
    }
}

} // namespace patina
