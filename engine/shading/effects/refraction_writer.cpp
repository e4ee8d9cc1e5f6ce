// SPDX-License-Identifier: GPL-3.0-or-later
// The part of SurfaceWriter that writes what is seen through a transparent body.
#include <algorithm>

#include <fmt/format.h>

#include "shading/effects/environment_source.h"
#include "shading/effects/refraction_choice.h"
#include "shading/effects/surface_writer.h"

namespace patina {
namespace {

/// One ray stands for all colours where they bend alike: green.
const char* channelSource(const BlockUse& use) {
    for (const CompiledValue& value : use.compiled) {
        if (value.id == "dispersion" && value.value == "nonzero") {
            return "#define FIRST_CHANNEL 0\n#define LAST_CHANNEL 2\n";
        }
    }
    return "#define FIRST_CHANNEL 1\n#define LAST_CHANNEL 1\n";
}

std::string namesSource(const Block& block) {
    const std::string function = functionName(block);
    return fmt::format("#define Refraction {0}\n#define refractedRay {1}\n"
                       "#define mirroredShare {1}Mirrored\n#define leftShare {1}Left\n",
                       structName(block), function);
}

} // namespace

/// A model that lets light pass has taken its share from what it gives back; so does the opacity.
void SurfaceWriter::writeKeptShare() {
    const auto passes = [](const Parameter& parameter) { return parameter.transparency; };
    if (set_.opacity && std::ranges::any_of(object_.model->block->parameters, passes)) {
        main_ += fmt::format("    shaded *= objectData[{}].y;\n", ObjectLayout::surface);
    }
}

void SurfaceWriter::writeDistance() {
    if (scene_.environment == nullptr) {
        out_.add(fmt::format("#define REFRACTION_BACKGROUND {}\n", object_.refractionBackground()));
        out_.addFile("passes/refraction_plain.glsl");
        return;
    }
    if (!object_.model) {
        addEnvironment(out_, *scene_.environment, *set_.scene.environment);
    }
    out_.addFile("passes/environment_points.glsl");
    out_.addFile("passes/refraction_environment.glsl");
}

/// What passes takes the place of what would be blended with: the pixel hides what is behind it.
/// The inspection looks at the surface alone.
void SurfaceWriter::writeRefraction() {
    if (!object_.refraction || isInspected()) {
        return;
    }
    const Block& block = *object_.refraction->block;
    writeDistance();
    readFrom("objectData");
    writeBlock(block);
    writeUnpack(block, *set_.refraction, "unpackRefraction");
    out_.add(namesSource(block) + channelSource(*set_.refraction));
    out_.addFile("passes/refraction_passage.glsl");
    // The way inside is looked along only where there is one.
    out_.add(isSheet(block) ? "#define STEPS_INSIDE 0\n" : "#define STEPS_INSIDE 8\n");
    out_.addFile(set_.scene.isShownRefracted ? "passes/refraction_behind.glsl"
                                             : "passes/refraction_alone.glsl");
    out_.addFile(isSheet(block) ? "passes/refraction_sheet.glsl" : "passes/refraction_body.glsl");
    out_.addFile("passes/refraction.glsl");
    last_ += fmt::format("    {0} = refracted(s, {0}, {1}, unpackRefraction({2}));\n", stored_,
                         alpha_, object_.refraction->first);
    alpha_ = "1.0";
}

} // namespace patina
