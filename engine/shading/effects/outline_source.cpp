// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/outline_source.h"

#include <string>

#include <fmt/format.h>

#include "shading/glsl/source_builder.h"
#include "shading/program/block_source.h"

namespace patina {
namespace {

void readFrom(SourceBuilder& out, const char* array) {
    out.add(
        fmt::format("#undef PARAMETER_DATA\n#define PARAMETER_DATA(i) {}[base + (i)]\n", array));
}

std::string sizeSource(const OutlineLayout& layout) {
    return fmt::format("#define OBJECT_VEC4S {}\n", layout.vec4s());
}

/// The block, with `Outline` for its struct and `unpackOutline` for what fills it.
void addBlock(SourceBuilder& out, const OutlineLayout& layout, const BlockUse& use) {
    const Block& block = *layout.block.block;
    out.addFile("passes/blocks.glsl");
    readFrom(out, "objectData");
    out.add(constantsSource(block) + structSource(block));
    out.addBlock(block);
    out.add(unpackSource(block, {"unpackOutline", use.compiled}));
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
    addBlock(out, layout, use);
    out.addFile("passes/outline.glsl");
    out.add(fmt::format("void main() {{\n    drawEdge(unpackOutline({}));\n}}\n",
                        OutlineLayout::fixed));
}

/// Declares the scene's array and what main calls for its fog.
void addFog(SourceBuilder& out, const BlockUse& use, const BlockPlace& fog, int sceneVec4s) {
    const Block& block = *fog.block;
    out.add(fmt::format("layout(std140) uniform SceneBlock {{\n    vec4 sceneData[{}];\n}};\n",
                        sceneVec4s));
    readFrom(out, "sceneData");
    out.add(constantsSource(block) + structSource(block));
    out.addBlock(block);
    out.add(unpackSource(block, {"unpackFog", use.compiled}));
    out.add(fmt::format("#define Fog {0}\n#define fogShare {1}\n#define fogColor {1}Color\n",
                        structName(block), functionName(block)));
    out.addFile("passes/outline_fog.glsl");
}

} // namespace

std::optional<OutlineLayout> outlineLayout(const EffectSet& set, const Catalog& catalog) {
    const Block* block = set.outline ? catalog.find(kinds::outline, set.outline->id) : nullptr;
    if (block == nullptr) {
        return std::nullopt;
    }
    return OutlineLayout{{block, layoutOf(*block), OutlineLayout::fixed}};
}

Checked<ProgramSource> outlineProgram(const EffectSet& set, const Catalog& catalog,
                                      int sceneVec4s) {
    const OutlineLayout layout = *outlineLayout(set, catalog);
    const SceneLayout scene = sceneLayout(set.scene, catalog);
    return program(
        catalog, [&](SourceBuilder& vertex) { writeVertex(vertex, layout); },
        [&](SourceBuilder& fragment) {
            fragment.add(sizeSource(layout));
            addBlock(fragment, layout, *set.outline);
            fragment.addFile("passes/outline.frag");
            std::string color = fmt::format("lineColor(unpackOutline({}))", OutlineLayout::fixed);
            if (scene.fog) {
                addFog(fragment, *set.scene.fog, *scene.fog, sceneVec4s);
                color = fmt::format("foggedLine({}, unpackFog({}))", color, scene.fog->first);
            }
            fragment.add("void main() {\n    storeLine(" + color + ");\n}\n");
        },
        [&](SourceBuilder& geometry) { writeGeometry(geometry, layout, *set.outline); });
}

} // namespace patina
