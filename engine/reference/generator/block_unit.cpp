// SPDX-License-Identifier: GPL-3.0-or-later
#include "block_unit.h"

#include <algorithm>

#include <fmt/format.h>

#include "catalog/parameter_layout.h"
#include "catalog/table_source.h"
#include "core/text.h"

namespace patina {
namespace {

/// Blocks that are functions of Directions.
bool isSurface(std::string_view kind) {
    return kind == "models" || kind == "specular";
}

const std::vector<EnumValue>* choicesOf(const ParameterField& field) {
    if (field.choice != nullptr) {
        return &field.choice->values;
    }
    return field.parameter->type == ParameterType::Enum ? &field.parameter->values : nullptr;
}

std::string constants(const Block& block, const ParameterField& field) {
    std::string text;
    const std::vector<EnumValue>* choices = choicesOf(field);
    for (std::size_t i = 0; choices != nullptr && i < choices->size(); ++i) {
        text += fmt::format("[[maybe_unused]] constexpr int {}_{}_{} = {};\n",
                            constantCase(structName(block)), constantCase(field.name),
                            constantCase((*choices)[i].id), i);
    }
    return text;
}

std::string fieldType(const ParameterField& field) {
    if (choicesOf(field) != nullptr) {
        return "int";
    }
    switch (field.parameter->type) {
    case ParameterType::Bool:
        return "bool";
    case ParameterType::Int:
        return "int";
    case ParameterType::Vec2:
        return "vec2";
    case ParameterType::Vec3:
    case ParameterType::Color:
        return "vec3";
    default:
        return "double";
    }
}

std::string unpackedField(const ParameterField& field) {
    const std::string type = fieldType(field);
    std::string value = fmt::format("data[{}]", field.offset);
    for (int i = 1; i < field.components; ++i) {
        value += fmt::format(", data[{}]", field.offset + static_cast<std::size_t>(i));
    }
    if (type == "bool") {
        return fmt::format("    p.{} = {} != 0.0;\n", field.name, value);
    }
    return fmt::format("    p.{} = {}({});\n", field.name, type, value);
}

/// The struct, its constants and the function that fills it from packed values.
std::string structCode(const Block& block, const ParameterLayout& layout) {
    std::string constantLines;
    std::string fields;
    std::string unpacked;
    for (const ParameterField& field : layout.fields) {
        constantLines += constants(block, field);
        fields += fmt::format("    {} {}{{}};\n", fieldType(field), field.name);
        unpacked += unpackedField(field);
    }
    for (const ParameterField& field : layout.fields) {
        if (field.parameter != nullptr && field.parameter->compiled == Compiled::WhenEqual) {
            fields += fmt::format("    bool {}Equal{{}};\n", field.name);
            unpacked += fmt::format("    p.{0}Equal = p.{0} == p.{1};\n", field.name,
                                    fieldName(field.parameter->equalTo));
        }
    }
    for (const Slot& slot : block.slots) {
        fields += fmt::format("    {}Slot {};\n", capitalised(slot.kind), slot.kind);
    }
    return fmt::format("{0}\nstruct {1} {{\n{2}}};\n\n"
                       "{1} unpack([[maybe_unused]] Parameters data) {{\n    {1} p;\n{3}"
                       "    return p;\n}}\n\n",
                       constantLines, structName(block), fields, unpacked);
}

/// How the blocks of a kind are called from a slot.
struct SlotCall {
    std::string_view kind;
    std::string_view argument; ///< as the model's GLSL passes it
    std::string_view call;     ///< of the compiled block
};
constexpr SlotCall slotCalls[] = {
    {"fresnel", "Incidence i", "fresnel(i.c, i.versine, slot.filler->parameters)"},
    {"specular", "Directions", "model(*slot.geometry, slot.filler->parameters, {})"},
};

/// What a model calls to use its slots; stands after the library because it needs its structs.
std::string slotCode(const Block& block) {
    std::string code;
    for (const SlotCall& slot : slotCalls) {
        if (block.slot(slot.kind) != nullptr) {
            const std::string word = capitalised(slot.kind);
            code +=
                fmt::format("vec3 slot{0}({1}, {0}Slot slot) {{\n"
                            "    return slot.filler == nullptr ? vec3(0.0)\n"
                            "                                  : slot.filler->block->{2};\n}}\n",
                            word, slot.argument, slot.call);
        }
    }
    return code;
}

/// The functions that the table points at, by kind; {0} is the block's function.
std::string entryFunctions(const Block& block) {
    const std::string name = functionName(block);
    if (isSurface(block.kind)) {
        std::string slots;
        for (const Slot& slot : block.slots) {
            slots += fmt::format("    p.{0} = filledSlot(fillers, \"{0}\", g);\n", slot.kind);
        }
        return fmt::format("vec3 callModel(const Geometry& g, Parameters data,\n"
                           "               [[maybe_unused]] Fillers fillers) {{\n"
                           "    {} p = unpack(data);\n{}"
                           "    Directions d = directions(g.n, g.t, g.b, g.l, g.v);\n"
                           "    d.pixel = g.pixel;\n    return {}(d, p);\n}}\n",
                           structName(block), slots, name);
    }
    if (block.kind == "fresnel") {
        return fmt::format("vec3 callFresnel(double c, double versine, Parameters data) {{\n"
                           "    Incidence i;\n    i.c = c;\n    i.versine = versine;\n"
                           "    return {0}(i, unpack(data));\n}}\n"
                           "vec3 callTint(Parameters data) {{ return {0}Tint(unpack(data)); }}\n",
                           name);
    }
    if (block.kind == "lights") {
        return fmt::format("reference::Illumination callLight(const vec3& x, Parameters data) {{\n"
                           "    const Illumination i = {}(x, unpack(data));\n    return {{i.l, "
                           "i.radiance}};\n}}\n",
                           name);
    }
    if (block.kind == "environment") {
        return fmt::format("vec3 callEnvironment(const vec3& d, const vec3& picture,\n"
                           "                     Parameters data) {{\n"
                           "    Outlook o;\n    o.d = d;\n    o.picture = picture;\n"
                           "    return {0}(o, unpack(data));\n}}\n",
                           name);
    }
    if (block.kind == "refraction") {
        return fmt::format("Crossing crossingOf(const reference::Crossing& x) {{\n"
                           "    Crossing c;\n    c.l = x.l;\n    c.n = x.n;\n"
                           "    c.channel = x.channel;\n    c.leaves = x.leaves;\n"
                           "    return c;\n}}\n"
                           "vec3 callRefract(const reference::Crossing& x, Parameters data) {{\n"
                           "    return {0}(crossingOf(x), unpack(data));\n}}\n"
                           "double callMirrored(const reference::Crossing& x, Parameters data) {{\n"
                           "    return {0}Mirrored(crossingOf(x), unpack(data));\n}}\n"
                           "vec3 callLeft(double way, Parameters data) {{\n"
                           "    return {0}Left(way, unpack(data));\n}}\n",
                           name);
    }
    if (block.kind == "transparency") {
        return fmt::format("double callTransparency(double depth, double opacity,\n"
                           "                        Parameters data) {{\n"
                           "    Layer l;\n    l.depth = depth;\n    l.opacity = opacity;\n"
                           "    return {0}(l, unpack(data));\n}}\n",
                           name);
    }
    if (block.kind == "outline") {
        return fmt::format("glm::dvec2 callOutline(const reference::Edge& x, Parameters data) {{\n"
                           "    Edge e;\n    e.turns = x.turns;\n    e.ends = x.ends;\n"
                           "    e.bend = x.bend;\n    return {0}(e, unpack(data));\n}}\n"
                           "vec3 callLineColor(Parameters data) {{\n"
                           "    return {0}Color(unpack(data));\n}}\n",
                           name);
    }
    return fmt::format(
        "double callFog(const reference::FogRay& x, Parameters data) {{\n    FogRay ray;\n"
        "    ray.eye = x.eye;\n    ray.direction = x.direction;\n    ray.range = x.range;\n"
        "    return {0}(ray, unpack(data));\n}}\n"
        "vec3 callFogColor(Parameters data) {{ return {0}Color(unpack(data)); }}\n",
        name);
}

std::string entryAssignments(const std::string& kind) {
    if (isSurface(kind)) {
        return "    block.model = &callModel;\n";
    }
    if (kind == "fresnel") {
        return "    block.fresnel = &callFresnel;\n    block.tint = &callTint;\n";
    }
    if (kind == "lights") {
        return "    block.light = &callLight;\n";
    }
    if (kind == "environment") {
        return "    block.environment = &callEnvironment;\n";
    }
    if (kind == "refraction") {
        return "    block.refract = &callRefract;\n    block.mirrored = &callMirrored;\n"
               "    block.left = &callLeft;\n";
    }
    if (kind == "transparency") {
        return "    block.transparency = &callTransparency;\n";
    }
    if (kind == "outline") {
        return "    block.outline = &callOutline;\n    block.lineColor = &callLineColor;\n";
    }
    return "    block.fog = &callFog;\n    block.fogColor = &callFogColor;\n";
}

std::string entry(const Block& block, const ParameterLayout& layout) {
    std::string fields;
    for (const ParameterField& field : layout.fields) {
        fields += fmt::format("        Field{{\"{}\", {}, {}}},\n", field.name, field.offset,
                              field.components);
    }
    const std::string table =
        fields.empty() ? "    block.fields = {};\n"
                       : fmt::format("    static constexpr Field fields[] = {{\n{}    }};\n"
                                     "    block.fields = fields;\n",
                                     fields);
    return fmt::format("Block block() {{\n    Block block;\n    block.kind = \"{}\";\n"
                       "    block.id = \"{}\";\n    block.size = {};\n"
                       "    block.lightGate = {};\n    block.viewGate = {};\n{}{}"
                       "    return block;\n}}\n",
                       block.kind, block.id, layout.floats, block.hasGate("light"),
                       block.hasGate("view"), table, entryAssignments(block.kind));
}

} // namespace

std::string unitFile(const Block& block) {
    return block.kind + '-' + block.id + ".cpp";
}

std::string unitScope(const Block& block) {
    return block.kind + '_' + functionName(block);
}

std::string blockSource(const Block& block, const GlslLines& lines) {
    const ParameterLayout layout = layoutOf(block);
    const std::string own = block.shaderFile.generic_string();
    const auto firstOwn = std::find_if(lines.begin(), lines.end(),
                                       [&](const GlslLine& line) { return line.file == own; });
    // The library's lines may interleave with the block's includes; only text counts.
    GlslLines library(lines.begin(), firstOwn);
    GlslLines code;
    for (auto line = firstOwn; line != lines.end(); ++line) {
        (line->file == own ? code : library).push_back(*line);
    }
    return fmt::format("#include \"reference/elementary.h\"\n#include \"reference/glsl.h\"\n\n"
                       "namespace patina::reference::{0} {{\n\n{1}\n#line 1 \"generated\"\n"
                       "{2}{3}\n{7}{4}\n#line 1 \"generated\"\n{8}{5}\n{6}\n"
                       "}} // namespace patina::reference::{0}\n",
                       unitScope(block), asCpp(library), slotCode(block), structCode(block, layout),
                       asCpp(code), entryFunctions(block), entry(block, layout),
                       tableDeclarations(block), asCpp(computedTables(block)));
}

std::string registrySource(const std::vector<Block>& blocks) {
    std::string declarations;
    std::string entries;
    for (const Block& block : blocks) {
        declarations += fmt::format("namespace {} {{\nBlock block();\n}}\n", unitScope(block));
        entries += fmt::format("        {}::block(),\n", unitScope(block));
    }
    return fmt::format(
        "#include \"reference/reference.h\"\n\nnamespace patina::reference {{\n\n{}\n"
        "std::span<const Block> blocks() {{\n    static const Block table[] = {{\n{}"
        "    }};\n    return table;\n}}\n\n}} // namespace patina::reference\n",
        declarations, entries);
}

} // namespace patina
