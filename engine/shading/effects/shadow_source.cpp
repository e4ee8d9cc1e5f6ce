// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/shadow_source.h"

#include <fmt/format.h>

#include "shading/effects/texture_writer.h"
#include "shading/effects/textures.h"
#include "shading/program/source_builder.h"

namespace patina {
namespace {

constexpr const char* opacityId = "opacity";

void addAlphaTest(SourceBuilder& out, const OpacityPart& tested) {
    const TextureWriter textures(tested.set, tested.layout);
    out.add(fmt::format("#define OBJECT_VEC4S {}\n#define OPACITY objectData[{}].x\n",
                        tested.layout.vec4s, ObjectLayout::surface));
    textures.writeOpacityDeclarations(out);
    std::string alpha = "OPACITY";
    const std::string decided = textures.opacity(alpha);
    if (tested.set.textures.front().cutOut) {
        out.add("void main() {\n" + decided + "}\n");
        return;
    }
    out.addFile("passes/shadows_alpha_test.glsl");
    out.add("void main() {\n" + decided +
            "    if (there < MIN_SHADOWING) {\n        discard;\n    }\n}\n");
}

} // namespace

bool isAlphaTested(const Material& material) {
    return isTextured(opacityId, material);
}

std::optional<OpacityPart> alphaTestOf(const Material& material, const Catalog& catalog) {
    if (!isAlphaTested(material)) {
        return std::nullopt;
    }
    OpacityPart part;
    part.set.opacity = true;
    const TextureUse& use = material.textures.find(opacityId)->second;
    part.set.textures = {boundTexture(use, textureTarget(opacityId, use, material, catalog))};
    part.set.TexturesEffect::place(part.layout, part.set);
    part.image = 0;
    return part;
}

Checked<ProgramSource> shadowMapProgram(const Catalog& catalog) {
    return program(
        catalog,
        [](SourceBuilder& vertex) {
            vertex.addFile("passes/shadows_map.vert");
            vertex.add("void main() {\n    placeInMap();\n}\n");
        },
        [](SourceBuilder& fragment) { fragment.add("void main() {\n}\n"); });
}

Checked<ProgramSource> shadowMapProgram(const OpacityPart& tested, const Catalog& catalog) {
    return program(
        catalog,
        [&](SourceBuilder& vertex) {
            const std::string images = TextureWriter(tested.set, tested.layout).writeVertex(vertex);
            vertex.addFile("passes/shadows_map.vert");
            vertex.add("void main() {\n    placeInMap();\n" + images + "}\n");
        },
        [&](SourceBuilder& fragment) { addAlphaTest(fragment, tested); });
}

} // namespace patina
