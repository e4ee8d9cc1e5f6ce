// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/surface_buffer_layout.h"

#include <fmt/format.h>

#include "shading/effects/effect_set.h"
#include "shading/effects/surface_text.h"

namespace patina {
namespace {

/// Notes the values of an image's parameters, each behind the statement that changed it.
void noteValues(SurfaceText& text, std::string_view kind, const std::string& variable) {
    text.main += text.textures.values(kind, variable);
    const std::vector<std::size_t> inputs = texturedInputs(text.set);
    for (std::size_t place = 0; place < inputs.size(); ++place) {
        const BoundTexture& texture = text.set.textures[inputs[place]];
        if (texture.kind == kind) {
            text.main += fmt::format("    noteValue({}, vec4(vec3({}.{}), 0.0));\n", place,
                                     variable, fieldName(texture.parameter->id));
        }
    }
}

void writeModelValues(SurfaceText& text) {
    const BlockUse& use = *text.set.model;
    const Block& model = use.block();
    writeSlots(text);
    text.out.add(constantsSource(model) + structSource(model));
    text.out.add(unpackSource(model, {"unpackModel", use.compiled(), text.filled}));
    text.main += fmt::format("    {} model = unpackModel({});\n", structName(model),
                             text.object.model->first);
    noteValues(text, kinds::models, "model");
    for (const SlotFill& slot : text.filled) {
        noteValues(text, slot.kind, fmt::format("model.{}", slot.kind));
    }
}

void writeBlendValues(SurfaceText& text) {
    const Block& block = text.set.blend->block();
    text.addBlock(block);
    text.addUnpack(*text.set.blend, "unpackBlend");
    text.main += fmt::format("    {} blend = unpackBlend({});\n", structName(block),
                             text.object.part(block.kind)->first);
    noteValues(text, block.kind, "blend");
}

/// Writes where the environment's light comes from in one round, or, of a drawing, as one light.
void writeSamples(SurfaceText& text) {
    if (!text.set.model || !isLitByEnvironment(text.set)) {
        return;
    }
    if (takesKeyAlone(text.set)) {
        addEnvironment(text.out, *text.set.environment, EnvironmentLayout::harmonics);
        addIrradiance(text.out, *text.set.environment);
        text.out.addFile("passes/environment_one_sample.glsl");
        text.main += "    noteOneLight();\n";
        return;
    }
    text.addOpenDirections();
    addEnvironment(text.out, *text.set.environment);
    text.out.addFile("passes/environment_points.glsl");
    text.out.addFile("passes/environment_samples.glsl");
    text.main +=
        fmt::format("    noteSamples(s, unpackEnvironment({}));\n", EnvironmentLayout::fixed);
}

void writeShares(SurfaceText& text, std::size_t index) {
    const LightPlace& group = text.scene.groups[index];
    const BlockUse& use = text.set.lights[index].block;
    const std::string type = structName(use.block());
    text.addBlock(use.block());
    text.addUnpack(use, fmt::format("unpack{}{}", type, index));
    writeShadow(text, index);
    text.out.add(fmt::format("void noteShares{0}(Surface s) {{\n"
                             "    int count = int(sceneData[{1}].x);\n"
                             "    int first = int(sceneData[{1}].y);\n"
                             "    for (int i = 0; i < count; ++i) {{\n"
                             "        {2} source = unpack{2}{0}(first + i * {3});\n"
                             "        Illumination light = {4}(s.x, source);\n"
                             "        noteShare(arriving{0}(s, light, first + i * {3}));\n"
                             "    }}\n"
                             "}}\n",
                             index, group.light.first, type, group.vec4s(),
                             functionName(use.block())));
    text.main += fmt::format("    noteShares{}(s);\n", index);
}

/// Writes what shadows leave of each light that has some.
void writeAllShares(SurfaceText& text) {
    if (!text.set.model || !hasShadows(text.set)) {
        return;
    }
    text.readFrom("sceneData");
    text.out.addFile("lib/illumination.glsl");
    writeShadowCode(text);
    for (std::size_t i = 0; i < text.set.lights.size(); ++i) {
        if (text.set.lights[i].shadow) {
            writeShares(text, i);
        }
    }
}

} // namespace

std::vector<std::size_t> texturedInputs(const EffectSet& set) {
    std::vector<std::size_t> inputs;
    for (std::size_t i = 0; i < set.textures.size(); ++i) {
        if (set.textures[i].role == TextureRole::Input) {
            inputs.push_back(i);
        }
    }
    return inputs;
}

std::size_t firstEffectValue(const EffectSet& set) {
    constexpr int values = SurfaceBufferLayout::samples * SurfaceBufferLayout::sampleValues;
    return texturedInputs(set).size() + (isLitByEnvironment(set) ? values : 0);
}

std::size_t firstShare(const EffectSet& set) {
    std::size_t place = firstEffectValue(set);
    set.each([&place](const auto& effect) {
        if constexpr (requires { effect.bufferValues(); }) {
            place += static_cast<std::size_t>(effect.bufferValues());
        }
    });
    return place;
}

void writeBuffer(SurfaceText& text) {
    text.out.add(fmt::format("#define FIRST_SAMPLE {}\n#define FIRST_SHARE {}\n",
                             texturedInputs(text.set).size(), firstShare(text.set)));
    text.out.addFile("passes/surface_buffer.glsl");
    if (text.set.model) {
        writeModelValues(text);
    }
    if (text.set.blend) {
        writeBlendValues(text);
    }
    std::size_t place = firstEffectValue(text.set);
    text.set.each([&](const auto& effect) {
        if constexpr (requires { effect.writeBuffer(text, place); }) {
            effect.writeBuffer(text, place);
            place += static_cast<std::size_t>(effect.bufferValues());
        }
    });
    writeSamples(text);
    writeAllShares(text);
    text.set.OpacityEffect::write(text);
    text.out.add(fmt::format("void main() {{\n    clearValues();\n    Surface s = surface();\n"
                             "{}{}    storeBuffer(s, {});\n}}\n",
                             text.main, text.last, text.alpha));
}

} // namespace patina
