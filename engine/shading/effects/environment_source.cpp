// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/environment_source.h"

#include <fmt/format.h>

#include "scene/environment.h"
#include "shading/effects/data_layout.h"
#include "shading/program/block_source.h"

namespace patina {

void addEnvironment(SourceBuilder& out, const Block& block, const BlockUse& use) {
    out.add(fmt::format("#define ENVIRONMENT_VEC4S {}\n",
                        EnvironmentLayout::fixed + vec4Count(block)));
    out.addFile("passes/environment.glsl");
    const bool hasPicture = pictureParameter(block) != nullptr;
    if (hasPicture) {
        out.addFile("passes/environment_picture.glsl");
    }
    out.add("#undef PARAMETER_DATA\n#define PARAMETER_DATA(i) environmentData[base + (i)]\n");
    out.add(constantsSource(block) + structSource(block));
    out.addBlock(block);
    out.add(unpackSource(block, {"unpackEnvironment", use.compiled}));
    out.add(fmt::format("#define Environment {}\n#define environmentValue {}\n"
                        "#define ENVIRONMENT_PICTURE(d) {}\n",
                        structName(block), functionName(block),
                        hasPicture ? "environmentPicture(d)" : "vec3(1.0)"));
    out.addFile("passes/environment_radiance.glsl");
}

namespace {

void addOutput(SourceBuilder& out, EnvironmentOutput output) {
    if (output == EnvironmentOutput::Small) {
        out.addFile("passes/environment_bake.glsl");
        return;
    }
    out.addFile("passes/environment_points.glsl");
    out.addFile(output == EnvironmentOutput::SharpBackground ? "passes/environment_sharp.glsl"
                                                             : "passes/environment_blurred.glsl");
    out.addFile("passes/environment_background.glsl");
}

} // namespace

Checked<ProgramSource> environmentProgram(const Block& block, const BlockUse& use,
                                          const Catalog& catalog, EnvironmentOutput output) {
    return screenProgram(catalog, [&](SourceBuilder& fragment) {
        addEnvironment(fragment, block, use);
        addOutput(fragment, output);
    });
}

} // namespace patina
