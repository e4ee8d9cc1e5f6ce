// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/shadow_source.h"

#include <fmt/format.h>

#include "shading/effects/texture_writer.h"
#include "shading/effects/textures.h"
#include "shading/glsl/source_builder.h"

namespace patina {
namespace {

constexpr const char* opacityId = "opacity";

void addHoles(SourceBuilder& out, const OpacityPart& holes) {
    const TextureWriter textures(holes.set, holes.layout);
    out.add(fmt::format("#define OBJECT_VEC4S {}\n#define OPACITY objectData[{}].x\n",
                        holes.layout.vec4s, ObjectLayout::surface));
    textures.writeOpacityDeclarations(out);
    std::string alpha = "OPACITY";
    const std::string decided = textures.opacity(alpha);
    if (holes.set.textures.front().cutOut) {
        out.add("void main() {\n" + decided + "}\n");
        return;
    }
    out.addFile("passes/shadow_holes.glsl");
    out.add("void main() {\n" + decided +
            "    if (there < MIN_SHADOWING) {\n        discard;\n    }\n}\n");
}

} // namespace

bool hasHoles(const Material& material) {
    return isTextured(opacityId, material);
}

std::optional<OpacityPart> holesOf(const Material& material, const Catalog& catalog) {
    if (!hasHoles(material)) {
        return std::nullopt;
    }
    OpacityPart part;
    part.set.opacity = true;
    const TextureUse& use = material.textures.find(opacityId)->second;
    part.set.textures = {boundTexture(use, textureTarget(opacityId, use, material, catalog))};
    part.layout.firstTexture = part.layout.vec4s;
    part.layout.vec4s = part.layout.texture(1);
    part.image = 0;
    return part;
}

Checked<ProgramSource> shadowMapProgram(const Catalog& catalog) {
    return program(
        catalog,
        [](SourceBuilder& vertex) {
            vertex.addFile("passes/shadow_map.vert");
            vertex.add("void main() {\n    placeInMap();\n}\n");
        },
        [](SourceBuilder& fragment) { fragment.add("void main() {\n}\n"); });
}

Checked<ProgramSource> shadowMapProgram(const OpacityPart& holes, const Catalog& catalog) {
    return program(
        catalog,
        [&](SourceBuilder& vertex) {
            const std::string images = TextureWriter(holes.set, holes.layout).writeVertex(vertex);
            vertex.addFile("passes/shadow_map.vert");
            vertex.add("void main() {\n    placeInMap();\n" + images + "}\n");
        },
        [&](SourceBuilder& fragment) { addHoles(fragment, holes); });
}

} // namespace patina
