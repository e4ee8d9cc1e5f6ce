// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/surface_writer.h"

#include <algorithm>

#include <fmt/format.h>

#include "shading/effects/environment_source.h"
#include "shading/effects/highlight_width.h"
#include "shading/program/block_source.h"
#include "shading/program/table_writer.h"

namespace patina {
namespace {

/// What a light adds: {0} is its Illumination, {1} what shadows leave of it (or the number of the
/// function that says so), {2} the function that asks the model.
constexpr const char* litSource = "    sum += {2}(s, {0}, p);\n";
constexpr const char* sharedLitSource = "    Illumination light = {0};\n"
                                        "    float share = arriving{1}(s, light, base);\n"
                                        "    if (share > 0.0) {{\n"
                                        "        sum = share * litAnyway(s, light, p);\n"
                                        "    }}\n";
constexpr const char* shadowedLitSource = "    Illumination light = {0};\n"
                                          "{1}"
                                          "    sum += {2}(s, light, p);\n";
constexpr const char* inspectedLitSource = "    Illumination light = inspectedLight({0});\n"
                                           "{1}"
                                           "    sum += {2}(s, light, p);\n"
                                           "    noteLight(s, light);\n";

/// When the model counts as 0 without being asked.
std::string gateSource(const Block& model) {
    std::string condition;
    if (model.hasGate("light")) {
        condition = "(d).nl <= 0.0";
    }
    if (model.hasGate("view")) {
        condition += condition.empty() ? "(d).nv <= 0.0" : " || (d).nv <= 0.0";
    }
    return condition.empty() ? "false" : condition;
}

/// What keeps a model's value from being negative: nothing, where it says that it never is, which
/// it says of unit normals. (What is stored is cut anyway.)
const char* cutSource(const Block& model, bool hasUnitNormals) {
    const bool isKept = std::ranges::find(model.claims, "non_negative") != model.claims.end();
    return isKept && hasUnitNormals ? "(color)" : "max(color, vec3(0.0))";
}

} // namespace

bool SurfaceWriter::isLitFromBehind() const {
    return object_.model && !object_.model->block->hasGate("light");
}

SurfaceWriter::SurfaceWriter(SourceBuilder& out, const EffectSet& set, const ObjectLayout& object,
                             const SceneLayout& scene)
    : out_(out), set_(set), object_(object), scene_(scene), textures_(set, object) {}

void SurfaceWriter::write(SurfaceOutput output) {
    output_ = output;
    if (output == SurfaceOutput::AlbedoTable) {
        writeAlbedoTable();
    } else if (output == SurfaceOutput::Tables) {
        writeTables();
    } else if (output == SurfaceOutput::Buffer) {
        writeBuffer();
    } else {
        writeSurface();
    }
}

void SurfaceWriter::writeSurface() {
    writeFrame();
    if (object_.ground) {
        writeGround();
    } else if (object_.model && lightsAtVertices()) {
        writeBlendedLight();
    } else if (object_.model) {
        writeSlots();
        writeModel();
        writeLights();
        writeAmbient();
        writeHemisphere();
        writeEnvironment();
        writeKeptShare();
    } else {
        out_.addFile("passes/fallback.glsl");
        main_ += "    shaded = fallback(s);\n";
    }
    writeBlend();
    writeEmission();
    writeFog();
    writeOpacity();
    writeRefraction();
    writeLayer();
    writeMain();
}

void SurfaceWriter::writeFrame() {
    out_.add(fmt::format("#define OBJECT_VEC4S {}\n", object_.vec4s));
    out_.addFile("passes/surface.glsl");
    if (leavesNormals()) {
        out_.addFile("passes/interpolated_normal.glsl");
    }
    if (isInspected()) {
        out_.addFile("passes/inspection.glsl");
    }
    textures_.writeDeclarations(out_);
    main_ += textures_.relief();
    readFrom("objectData");
}

/// The model alone.
void SurfaceWriter::writeAlbedoTable() {
    out_.add(fmt::format("#define OBJECT_VEC4S {}\n", object_.vec4s));
    for (const char* file : {"passes/blocks.glsl", "lib/directions.glsl", "lib/math.glsl"}) {
        out_.addFile(file);
    }
    readFrom("objectData");
    writeSlots();
    writeModel();
    const AlbedoTableShape shape = albedoTableShape(*object_.model->block);
    out_.add(fmt::format("#define TABLE_WIDTH {}\n#define TABLE_HEIGHT {}\n#define SECTORS {}\n",
                         shape.size.x, shape.size.y, shape.sectors));
    out_.addFile("passes/albedo_table.glsl");
    out_.add("void main() {\n" + main_ + "    storeAlbedo(model);\n}\n");
}

/// What a probe can read, as a statement of main behind the one that made it.
void SurfaceWriter::noteTerm(const std::string& term, const std::string& value,
                             const std::string& detail) {
    if (isInspected()) {
        main_ += fmt::format("    noteTerm(TERM_{}, {}, {});\n", term, value, detail);
    }
}

void SurfaceWriter::readFrom(const std::string& array) {
    out_.add(
        fmt::format("#undef PARAMETER_DATA\n#define PARAMETER_DATA(i) {}[base + (i)]\n", array));
}

void SurfaceWriter::writeBlock(const Block& block, std::span<const CompiledValue> compiled) {
    if (std::find(written_.begin(), written_.end(), &block) == written_.end()) {
        out_.add(constantsSource(block) + structSource(block, compiled));
        if (looksUp(block, object_.tables, output_)) {
            out_.addFile("passes/block_tables.glsl");
        }
        out_.add(textBeforeBlock(block, object_.tables, output_));
        out_.addBlock(block);
        out_.add(textBehindBlock(block, object_.tables, output_));
        written_.push_back(&block);
    }
}

void SurfaceWriter::writeUnpack(const Block& block, const BlockUse& use,
                                const std::string& function) {
    out_.add(unpackSource(block, {function, use.compiled}));
}

void SurfaceWriter::writeSlots() {
    for (std::size_t i = 0; i < object_.slots.size(); ++i) {
        const Block& block = *object_.slots[i].block;
        const std::string slot = slotStructName(block.kind);
        writeBlock(block);
        out_.add(slotNamesSource(block));
        writeUnpack(block, set_.slots[i], "unpack" + slot);
        filled_.push_back({block.kind, object_.slots[i].vec4s()});
    }
    for (const Slot& slot : object_.model->block->slots) {
        if (std::none_of(filled_.begin(), filled_.end(),
                         [&slot](const SlotFill& fill) { return fill.kind == slot.kind; })) {
            out_.add(emptySlotSource(slot.kind));
        }
    }
}

void SurfaceWriter::writeModel() {
    const Block& model = *object_.model->block;
    writeBlock(model, set_.model->compiled);
    out_.add(unpackSource(model, {"unpackModel", set_.model->compiled, filled_}));
    out_.add(fmt::format("#define Model {}\n#define {} {}\n#define IS_DARK(d) ({})\n"
                         "#define IS_UNLIT(nl) ({})\n"
                         "#define CUT_AT_ZERO(color) {}\n",
                         structName(model), isInspected() ? "modelValue" : "shadeModel",
                         functionName(model), gateSource(model),
                         isLitFromBehind() ? "false" : "(nl) <= 0.0",
                         cutSource(model, !leavesNormals())));
    if (isInspected()) {
        out_.addFile("passes/inspected_model.glsl");
        out_.add("#define shadeModel inspectedModel\n");
    }
    main_ += fmt::format("    Model model = unpackModel({});\n", object_.model->first);
    if (!isTable(output_)) {
        main_ += textures_.values("models", "model");
        for (const SlotFill& slot : filled_) {
            main_ += textures_.values(slot.kind, fmt::format("model.{}", slot.kind));
        }
    }
    if (isPicture() && set_.widensHighlights) {
        writeWideHighlights();
    }
}

/// Widens highlights by the curvature of the surface, after images have changed their widths.
void SurfaceWriter::writeWideHighlights() {
    out_.addFile("lib/math.glsl");
    out_.addFile("passes/widened_highlight.glsl");
    main_ += "    float spread = highlightSpread(s.n);\n" +
             widenedSource(*object_.model->block, "model");
    for (const BlockPlace& slot : object_.slots) {
        main_ += widenedSource(*slot.block, "model." + slot.block->kind);
    }
}

void SurfaceWriter::writeLights() {
    if (scene_.groups.empty()) {
        return;
    }
    out_.addFile("passes/lit.glsl");
    nextLine_ = scene_.firstLight;
    readFrom("sceneData");
    if (hasShadows()) {
        writeShadowCode();
    }
    for (std::size_t i = 0; i < scene_.groups.size(); ++i) {
        writeLightGroup(i);
    }
}

void SurfaceWriter::writeLightGroup(std::size_t index) {
    const LightPlace& group = scene_.groups[index];
    const Block& block = *group.light.block;
    const std::string type = structName(block);
    writeBlock(block);
    writeUnpack(block, set_.scene.lights[index].block, fmt::format("unpack{}{}", type, index));
    std::string shadowed;
    const char* body = isInspected() ? inspectedLitSource : litSource;
    const bool hasEnd = block.reach && set_.scene.lights[index].lines == 0;
    const char* lit = group.shadow || hasEnd ? "litWhereItArrives" : "lit";
    if (group.shadow) {
        writeShadow(index);
        body = isInspected() ? body : sharedLitSource;
        shadowed = isInspected() || set_.ground == GroundMode::Shadows
                       ? fmt::format("    light.radiance *= arriving{}(s, light, base);\n", index)
                       : fmt::format("{}", index);
    }
    if (set_.ground == GroundMode::Shadows) {
        body = shadowedLitSource;
        shadowed = fmt::format("    sent += {}(s, light, p);\n", lit) + shadowed;
    }
    const std::string arrives = fmt::format("{}(s.x, source)", functionName(block));
    out_.add(fmt::format("vec3 from{0}{1}(Surface s, Model p, int base) {{\n"
                         "    vec3 sum = vec3(0.0);\n"
                         "    {0} source = unpack{0}{1}(base);\n"
                         "{2}"
                         "    return sum;\n"
                         "}}\n",
                         type, index, fmt::format(fmt::runtime(body), arrives, shadowed, lit)));
    addLightGroup(index, fmt::format("from{}{}", type, index));
}

/// A line for each light, or the loop over them. Lines come first in `sceneData`.
void SurfaceWriter::addLightGroup(std::size_t index, const std::string& function) {
    const LightPlace& group = scene_.groups[index];
    const int lines = set_.scene.lights[index].lines;
    for (int i = 0; i < lines; ++i) {
        main_ += fmt::format("    shaded += {}(s, model, {});\n", function, nextLine_);
        nextLine_ += group.vec4s();
    }
    if (lines == 0) {
        main_ += fmt::format("    for (int i = 0; i < int(sceneData[{0}].x); ++i) {{\n"
                             "        shaded += {1}(s, model, int(sceneData[{0}].y) + i * {2});\n"
                             "    }}\n",
                             group.light.first, function, group.vec4s());
    }
}

/// The inspection looks at single values, of which the environment's light is a sum of many.
void SurfaceWriter::writeEnvironment() {
    if (scene_.environment == nullptr || isInspected()) {
        return;
    }
    addEnvironment(out_, *scene_.environment, *set_.scene.environment);
    out_.addFile("passes/environment_points.glsl");
    out_.addFile("passes/environment_light.glsl");
    main_ += fmt::format("    shaded += environmentLight(s, unpackEnvironment({}), model);\n",
                         EnvironmentLayout::fixed);
}

/// Once per pixel, whatever the number of lights: no Fresnel term covers what a surface sends out
/// by itself.
void SurfaceWriter::writeEmission() {
    for (const std::string& color : set_.emission) {
        main_ += fmt::format("    shaded += model.{};\n", fieldName(color));
        noteTerm("EMISSION", "model." + fieldName(color), "0.0");
    }
}

void SurfaceWriter::writeBlend() {
    if (!object_.blend) {
        return;
    }
    const Block& block = *object_.blend->block;
    readFrom("objectData");
    writeBlock(block);
    writeUnpack(block, *set_.blend, "unpackBlend");
    const std::string function = functionName(block);
    const char* share = isInspected() ? "blendShare(i, p) lookedShare({}(i, p))" : "blendShare {}";
    out_.add(fmt::format("#define Blend {}\n#define {}\n#define blendTint {}Tint\n",
                         structName(block), fmt::format(fmt::runtime(share), function), function));
    out_.addFile("passes/fresnel_blend.glsl");
    main_ += fmt::format("    Blend blend = unpackBlend({});\n", object_.blend->first);
    main_ += textures_.values(block.kind, "blend");
    main_ += "    shaded = fresnelBlended(s, shaded, blend);\n";
    noteTerm("BLENDED", "shaded", "share");
}

/// The fog's block, and what the passes call it.
void SurfaceWriter::writeFogBlock() {
    const Block& block = *scene_.fog->block;
    readFrom("sceneData");
    writeBlock(block);
    writeUnpack(block, *set_.scene.fog, "unpackFog");
    const std::string function = functionName(block);
    const char* share = isInspected() ? "fogShare(x, p) lookedShare({}(x, p))" : "fogShare {}";
    out_.add(fmt::format("#define Fog {}\n#define {}\n#define fogColor {}Color\n",
                         structName(block), fmt::format(fmt::runtime(share), function), function));
}

void SurfaceWriter::writeFog() {
    if (!scene_.fog) {
        return;
    }
    writeFogBlock();
    out_.addFile(fogsAtVertices() ? "passes/blended_fog.glsl" : "passes/fog.glsl");
    if (set_.ground == GroundMode::Shadows) {
        return; // they thin out with what they fall on
    }
    main_ += fmt::format("    shaded = fogged(s, shaded, unpackFog({}));\n", scene_.fog->first);
    noteTerm("FOGGED", "shaded", "share");
}

void SurfaceWriter::writeOpacity() {
    if (set_.opacity) {
        out_.add(fmt::format("#define OPACITY objectData[{}].x\n", ObjectLayout::surface));
        alpha_ = "OPACITY";
    }
    last_ = textures_.opacity(alpha_);
}

void SurfaceWriter::writeMain() {
    // The table knows one value for the whole surface.
    const char* albedo = object_.model && set_.textures.empty() ? "albedoAt(s)" : "vec4(0.0)";
    const std::string store =
        isInspected() ? fmt::format("storeInspected(s, {}, {}, {})", stored_, albedo, alpha_)
                      : fmt::format(fmt::runtime(store_), stored_, alpha_);
    out_.add(fmt::format("void main() {{\n{}    Surface s = {}();\n    vec3 shaded = vec3(0.0);\n"
                         "{}{}    {};\n}}\n",
                         isInspected() ? "    clearTerms();\n" : "",
                         leavesNormals() ? "blendedSurface" : "surface", main_, last_, store));
}

} // namespace patina
