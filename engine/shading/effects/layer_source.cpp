// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/layer_source.h"

#include <fmt/format.h>

#include "shading/effects/surface_program.h"
#include "shading/effects/texture_writer.h"
#include "shading/program/source_builder.h"

namespace patina {
namespace {

const char* samplerSource(bool isMultisampled) {
    return isMultisampled ? "#define LAYER_IMAGE sampler2DMS\n#define LAYER_SAMPLE gl_SampleID\n"
                          : "#define LAYER_IMAGE sampler2D\n#define LAYER_SAMPLE 0\n";
}

void addPeeling(SourceBuilder& out, const OpacityPart& part, bool isMultisampled) {
    const TextureWriter textures(part.set, part.layout);
    std::string alpha = "1.0";
    out.add(samplerSource(isMultisampled));
    out.add(fmt::format("#define OBJECT_VEC4S {}\n", part.layout.vec4s));
    if (part.set.opacity) {
        out.add(fmt::format("#define OPACITY objectData[{}].x\n", ObjectLayout::surface));
        alpha = "OPACITY";
    }
    textures.writeOpacityDeclarations(out);
    out.addFile("passes/transparency_peel.glsl");
    out.add("void main() {\n    if (isPeeled()) {\n        discard;\n    }\n" +
            textures.opacity(alpha) + "}\n");
}

} // namespace

Checked<ProgramSource> peelProgram(const OpacityPart& part, const Catalog& catalog,
                                   bool isMultisampled) {
    return program(
        catalog, [&](SourceBuilder& vertex) { addSurfaceVertex(vertex, part.set, part.layout); },
        [&](SourceBuilder& fragment) { addPeeling(fragment, part, isMultisampled); });
}

Checked<ProgramSource> layerComposition(const Catalog& catalog, bool isPeeled,
                                        bool isMultisampled) {
    return screenProgram(catalog, [&](SourceBuilder& fragment) {
        fragment.add(samplerSource(isMultisampled));
        fragment.addFile(isPeeled ? "passes/transparency_ordered.glsl"
                                  : "passes/transparency_mixed.glsl");
    });
}

} // namespace patina
