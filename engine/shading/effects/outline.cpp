// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/outline.h"

#include <string>

#include <fmt/format.h>

#include "shading/effects/effect_set.h"
#include "shading/program/source_builder.h"
#include "shading/program/block_source.h"
#include "shading/program/given_value.h"

namespace patina {
namespace {

std::string sizeSource(const OutlineLayout& layout) {
    return fmt::format("#define OBJECT_VEC4S {}\n", layout.vec4s());
}

/// Adds the block, with `Outline` for its struct and `unpackOutline` for what fills it.
void addOutlineBlock(SourceBuilder& out, const BlockUse& use) {
    const Block& block = use.block();
    out.addFile("passes/blocks.glsl");
    out.add(unpackedFrom("objectData"));
    out.add(constantsSource(block) + structSource(block));
    out.addBlock(block);
    out.add(unpackSource(block, {"unpackOutline", use.compiled()}));
    out.add(fmt::format("#define Outline {}\n#define lineWidths {}\n#define lineColor {}Color\n",
                        structName(block), functionName(block), functionName(block)));
}

void writeVertex(SourceBuilder& out, const OutlineLayout& layout) {
    out.add(sizeSource(layout));
    out.addFile("passes/outline.vert");
    out.add("void main() {\n    placeCorner();\n}\n");
}

void writeGeometry(SourceBuilder& out, const OutlineLayout& layout, const BlockUse& use) {
    out.add(sizeSource(layout));
    addOutlineBlock(out, use);
    out.addFile("passes/outline.glsl");
    out.add(fmt::format("void main() {{\n    drawEdge(unpackOutline({}));\n}}\n",
                        OutlineLayout::fixed));
}

/// Declares the scene's array and what main calls for its fog.
void addLineFog(SourceBuilder& out, const BlockUse& use, int sceneVec4s) {
    const Block& block = use.block();
    out.add(fmt::format("layout(std140) uniform SceneBlock {{\n    vec4 sceneData[{}];\n}};\n",
                        sceneVec4s));
    out.add(unpackedFrom("sceneData"));
    out.add(constantsSource(block) + structSource(block));
    out.addBlock(block);
    out.add(unpackSource(block, {"unpackFog", use.compiled()}));
    out.add(fmt::format("#define Fog {0}\n#define fogShare {1}\n#define fogColor {1}Color\n",
                        structName(block), functionName(block)));
    out.addFile("passes/outline_fog.glsl");
}

void writeFragment(SourceBuilder& out, const OutlineLayout& layout, const EffectSet& set,
                   int sceneVec4s) {
    out.add(sizeSource(layout));
    addOutlineBlock(out, *set.outline);
    out.addFile("passes/outline.frag");
    std::string color = fmt::format("lineColor(unpackOutline({}))", OutlineLayout::fixed);
    if (set.fog) {
        addLineFog(out, *set.fog, sceneVec4s);
        color = fmt::format("foggedLine({}, unpackFog({}))", color,
                            sceneLayout(set).part(kinds::fog)->first);
    }
    out.add("void main() {\n    storeLine(" + color + ");\n}\n");
}

} // namespace

OutlineChoice outlineChoice(const Material& material, const Catalog& catalog) {
    const BlockValues* part = material.part(kinds::outline);
    if (part == nullptr) {
        return {};
    }
    const Block* block = catalog.find(kinds::outline, part->id);
    if (block == nullptr) {
        return {nullptr, "No outline of this kind is known."};
    }
    bool hasWidths = false;
    for (const Parameter& parameter : block->parameters) {
        const bool isWidth = parameter.role == roles::width;
        if (isWidth && !notPositive(givenValue(parameter, part->parameters))) {
            return {block, ""};
        }
        hasWidths = hasWidths || isWidth;
    }
    return hasWidths ? OutlineChoice{nullptr, "Its lines are 0 pixels wide."}
                     : OutlineChoice{block, ""};
}

void OutlineEffect::choose(const MaterialSubject& subject, const EffectSet&) {
    const Block* block = outlineChoice(subject.material, subject.catalog).block;
    outline.reset();
    if (block != nullptr) {
        outline.emplace(*block, subject.material.part(kinds::outline)->parameters,
                        subject.material.accuracy);
    }
}

void OutlineEffect::list(EffectListing& listing, const EffectSet&) const {
    if (outline) {
        listing.add(*outline, always("The material has lines along the edges of its shape."));
    }
}

void OutlineEffect::listMissing(LeftOutListing& listing, const EffectSet&) const {
    const Material* material = listing.subject().material;
    const BlockValues* part = material == nullptr ? nullptr : material->part(kinds::outline);
    if (part != nullptr && !outline) {
        listing.add(effectName(kinds::outline, part->id),
                    outlineChoice(*material, listing.subject().catalog).whyNot);
    }
}

void OutlineEffect::remove(Scene& scene, const EffectName& effect, const Catalog&) {
    if (effect.kind == kinds::outline) {
        removePart(scene, effect);
    }
}

std::optional<OutlineLayout> outlineLayout(const EffectSet& set) {
    if (!set.outline) {
        return std::nullopt;
    }
    const Block& block = set.outline->block();
    return OutlineLayout{{&block, layoutOf(block), OutlineLayout::fixed}};
}

Checked<ProgramSource> outlineProgram(const EffectSet& set, const Catalog& catalog,
                                      int sceneVec4s) {
    const OutlineLayout layout = *outlineLayout(set);
    return program(
        catalog, [&](SourceBuilder& vertex) { writeVertex(vertex, layout); },
        [&](SourceBuilder& fragment) { writeFragment(fragment, layout, set, sceneVec4s); },
        [&](SourceBuilder& geometry) { writeGeometry(geometry, layout, *set.outline); });
}

} // namespace patina
