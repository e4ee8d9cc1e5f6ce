// SPDX-License-Identifier: GPL-3.0-or-later
// The part of SurfaceWriter that writes what a surface is shaded from, in place of its shading.

#include <fmt/format.h>

#include "shading/effects/environment_source.h"
#include "shading/effects/surface_writer.h"
#include "shading/program/surface_buffer_layout.h"

namespace patina {

std::vector<std::size_t> texturedInputs(const EffectSet& set) {
    std::vector<std::size_t> inputs;
    for (std::size_t i = 0; i < set.textures.size(); ++i) {
        if (set.textures[i].role == TextureRole::Input) {
            inputs.push_back(i);
        }
    }
    return inputs;
}

std::size_t firstShare(const EffectSet& set) {
    constexpr int values = SurfaceBufferLayout::samples * SurfaceBufferLayout::sampleValues;
    return texturedInputs(set).size() + (set.scene.environment ? values : 0);
}

/// The values of an image's parameters, each behind the statement that changed it.
void SurfaceWriter::noteValues(std::string_view kind, const std::string& variable) {
    main_ += textures_.values(kind, variable);
    const std::vector<std::size_t> inputs = texturedInputs(set_);
    for (std::size_t place = 0; place < inputs.size(); ++place) {
        const TextureEffect& effect = set_.textures[inputs[place]];
        if (effect.kind == kind) {
            main_ += fmt::format("    noteValue({}, vec4(vec3({}.{}), 0.0));\n", place, variable,
                                 effect.field);
        }
    }
}

void SurfaceWriter::writeBuffer() {
    writeFrame();
    out_.add(fmt::format("#define FIRST_SAMPLE {}\n#define FIRST_SHARE {}\n",
                         texturedInputs(set_).size(), firstShare(set_)));
    out_.addFile("passes/surface_buffer.glsl");
    if (object_.model) {
        writeSlots();
        out_.add(constantsSource(*object_.model->block) + structSource(*object_.model->block));
        out_.add(unpackSource(*object_.model->block,
                              {"unpackModel", set_.model->compiled, filled_}));
        main_ += fmt::format("    {} model = unpackModel({});\n",
                             structName(*object_.model->block), object_.model->first);
        noteValues("models", "model");
        for (const SlotFill& slot : filled_) {
            noteValues(slot.kind, fmt::format("model.{}", slot.kind));
        }
    }
    if (object_.blend) {
        const Block& block = *object_.blend->block;
        writeBlock(block);
        writeUnpack(block, *set_.blend, "unpackBlend");
        main_ += fmt::format("    {} blend = unpackBlend({});\n", structName(block),
                             object_.blend->first);
        noteValues(block.kind, "blend");
    }
    writeSamples();
    writeShares();
    writeOpacity();
    out_.add(fmt::format("void main() {{\n    clearValues();\n    Surface s = surface();\n"
                         "{}{}    storeBuffer(s, {});\n}}\n",
                         main_, last_, alpha_));
}

/// Where the environment's light comes from in one round.
void SurfaceWriter::writeSamples() {
    if (!object_.model || scene_.environment == nullptr) {
        return;
    }
    addEnvironment(out_, *scene_.environment, *set_.scene.environment);
    out_.addFile("passes/environment_points.glsl");
    out_.addFile("passes/environment_samples.glsl");
    main_ += fmt::format("    noteSamples(s, unpackEnvironment({}));\n",
                         EnvironmentLayout::fixed);
}

/// What shadows leave of each light that has some.
void SurfaceWriter::writeShares() {
    if (!object_.model || !hasShadows()) {
        return;
    }
    readFrom("sceneData");
    out_.addFile("lib/illumination.glsl");
    writeShadowCode();
    for (std::size_t i = 0; i < scene_.groups.size(); ++i) {
        const LightPlace& group = scene_.groups[i];
        if (!group.shadow) {
            continue;
        }
        const Block& block = *group.light.block;
        const std::string type = structName(block);
        writeBlock(block);
        writeUnpack(block, set_.scene.lights[i].block, fmt::format("unpack{}{}", type, i));
        writeShadow(i);
        out_.add(fmt::format("void noteShares{0}(Surface s) {{\n"
                             "    int count = int(sceneData[{1}].x);\n"
                             "    int first = int(sceneData[{1}].y);\n"
                             "    for (int i = 0; i < count; ++i) {{\n"
                             "        {2} source = unpack{2}{0}(first + i * {3});\n"
                             "        Illumination light = {4}(s.x, source);\n"
                             "        noteShare(arriving{0}(s, light, first + i * {3}));\n"
                             "    }}\n"
                             "}}\n",
                             i, group.light.first, type, group.vec4s(), functionName(block)));
        main_ += fmt::format("    noteShares{}(s);\n", i);
    }
}

} // namespace patina
