// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/display.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "shading/glsl/source_builder.h"
#include "shading/program/block_source.h"

namespace patina {
namespace {

constexpr const char* exposureName = "exposure";

/// Declares `toneMapped(vec3 light)`.
void addTone(SourceBuilder& out, const std::optional<BlockUse>& tone) {
    if (!tone) {
        out.add("#define toneMapped(light) (light)\n");
        return;
    }
    const Block& block = tone->block();
    const int vec4s = vec4Count(block);
    if (vec4s > 0) {
        out.add(fmt::format("uniform vec4 toneData[{}];\n", vec4s));
    }
    out.add(unpackedFrom("toneData"));
    out.add(constantsSource(block) + structSource(block, tone->compiled()));
    out.addBlock(block);
    out.add(unpackSource(block, {"unpackTone", tone->compiled()}));
    out.add(
        fmt::format("vec3 toneMapped(vec3 light) {{\n    return {}(light, unpackTone(0));\n}}\n",
                    functionName(block)));
}

} // namespace

DisplayEffect::DisplayEffect(const Scene& scene, const Catalog& catalog)
    : isExposed(scene.exposure != 0.0) {
    const BlockValues* part = scene.part(kinds::tone);
    const Block* block = part == nullptr ? nullptr : catalog.find(kinds::tone, part->id);
    if (block != nullptr) {
        tone.emplace(*block, part->parameters);
    }
}

std::uint64_t DisplayEffect::key() const {
    ChoiceHash hash;
    hash.add(isExposed);
    hash.add(tone);
    return hash.value();
}

void DisplayEffect::list(EffectListing& listing) const {
    if (isExposed) {
        listing.add(exposureName, {}, [](const EffectSubject& subject) {
            const double stops = subject.scene.exposure;
            return fmt::format("Everything is {:.4g} stops {}.", std::abs(stops),
                               stops > 0.0 ? "brighter" : "darker");
        });
    }
    if (tone) {
        listing.add(*tone, always("What is too bright for a display is compressed. What is above 1 "
                                  "behind the curve is cut off."));
    }
}

void DisplayEffect::listMissing(LeftOutListing& listing) const {
    if (!isExposed) {
        listing.add(exposureName, "It is 0 stops.");
    }
    if (tone) {
        return;
    }
    const BlockValues* part = listing.subject().scene.part(kinds::tone);
    if (part != nullptr) {
        listing.add(effectName(kinds::tone, part->id),
                    fmt::format("No tone curve \"{}\" is known.", part->id));
    } else {
        listing.add(std::string(kinds::tone), "None is chosen: what is above 1 is cut off.");
    }
}

void DisplayEffect::remove(Scene& scene, const EffectName& effect) {
    if (effect.kind == exposureName) {
        scene.exposure = 0.0;
    } else if (effect.kind == kinds::tone) {
        scene.setPart(kinds::tone, std::nullopt);
    }
}

Checked<ProgramSource> displayProgram(const DisplayEffect& display, const Catalog& catalog) {
    return screenProgram(catalog, [&display](SourceBuilder& fragment) {
        addTone(fragment, display.tone);
        fragment.addFile(display.isExposed ? "passes/exposed.glsl" : "passes/exposed_none.glsl");
        fragment.addFile("passes/display.frag");
    });
}

} // namespace patina
