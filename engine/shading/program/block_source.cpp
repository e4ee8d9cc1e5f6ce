// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/program/block_source.h"

#include <algorithm>

#include <fmt/format.h>

#include "catalog/function_source.h"
#include "catalog/parameter_layout.h"
#include "core/text.h"

namespace patina {
namespace {

std::string_view glslType(const ParameterField& field) {
    return field.parameter == nullptr ? "int" : infoOf(field.parameter->type).glsl;
}

const std::vector<EnumValue>& choicesOf(const ParameterField& field) {
    return field.parameter == nullptr ? field.choice->values : field.parameter->values;
}

const std::string& idOf(const ParameterField& field) {
    return field.parameter == nullptr ? field.choice->id : field.parameter->id;
}

std::string constantName(const Block& block, const ParameterField& field, std::string_view value) {
    return fmt::format("{}_{}_{}", constantCase(structName(block)), constantCase(field.name),
                       constantCase(value));
}

/// Returns where the field lies in the vec4s that were read: "d2.y", "d2.xyz".
std::string placeOf(const ParameterField& field) {
    constexpr std::string_view names = "xyzw";
    return fmt::format("d{}.{}", field.offset / 4,
                       names.substr(field.offset % 4, std::size_t(field.components)));
}

std::string readSource(const ParameterField& field) {
    const std::string_view type = glslType(field);
    if (type == "int") {
        return fmt::format("int(floor({} + 0.5))", placeOf(field));
    }
    return type == "bool" ? fmt::format("{} != 0.0", placeOf(field)) : placeOf(field);
}

/// Returns the name of the bool that says whether this field equals another; empty where there is
/// none.
std::string equalField(const ParameterField& field) {
    const bool compared =
        field.parameter != nullptr && field.parameter->compiled == Compiled::WhenEqual;
    return compared ? field.name + "Equal" : std::string();
}

const CompiledValue* compiledOf(const ParameterField& field, const UnpackRequest& request) {
    const auto found =
        std::find_if(request.compiled.begin(), request.compiled.end(),
                     [&field](const CompiledValue& value) { return value.id == idOf(field); });
    const bool isRead =
        found == request.compiled.end() || found->value == "nonzero" || !equalField(field).empty();
    return isRead || functionOf(field) != nullptr ? nullptr : &*found;
}

/// Tells whether the program knows that the function of a field is the plain one.
bool isPlain(const ParameterField& field, std::span<const CompiledValue> compiled) {
    const auto found = std::ranges::find(compiled, idOf(field), &CompiledValue::id);
    return found != compiled.end() && functionOf(field) != nullptr &&
           found->value == infoOf(field.parameter->type).stateWord(*field.parameter, 0);
}

/// Writes "p.curve = base + 3;", and whether the function is the plain one.
std::string unpackFunction(const ParameterField& field, const UnpackRequest& request) {
    const std::size_t first = field.offset / 4;
    std::string text = fmt::format("    p.{} = base + {};\n", field.name, first);
    if (const std::string plain = plainField(field); !plain.empty()) {
        const bool isKnown = std::ranges::find(request.compiled, idOf(field), &CompiledValue::id) !=
                             request.compiled.end();
        text += fmt::format("    p.{} = {};\n", plain,
                            !isKnown ? fmt::format("PARAMETER_DATA({}).x == 0.0", first)
                            : isPlain(field, request.compiled) ? "true"
                                                               : "false");
    }
    return text;
}

std::string compiledText(const Block& block, const ParameterField& field,
                         const CompiledValue& compiled) {
    if (compiled.value == "zero") {
        return "0.0";
    }
    return choicesOf(field).empty() ? std::string(compiled.value)
                                    : constantName(block, field, compiled.value);
}

/// Returns the macro of a field: "COMPILED_MODEL_DISTRIBUTION" for `distribution` of `unpackModel`.
std::string defineName(const ParameterField& field, const UnpackRequest& request) {
    std::string_view owner = request.function;
    if (owner.starts_with("unpack")) {
        owner.remove_prefix(6);
    }
    return fmt::format("COMPILED_{}_{}", constantCase(owner), constantCase(field.name));
}

/// Writes "p.roughnessYEqual = true;", as the program was compiled, or a comparison of both values.
std::string unpackEqual(const ParameterField& field, const UnpackRequest& request) {
    const std::string equal = equalField(field);
    const auto found =
        std::find_if(request.compiled.begin(), request.compiled.end(),
                     [&field](const CompiledValue& value) { return value.id == idOf(field); });
    if (found != request.compiled.end()) {
        return fmt::format("    p.{} = {};\n", equal, found->value == "equal" ? "true" : "false");
    }
    return fmt::format("    p.{} = p.{} == p.{};\n", equal, field.name,
                       fieldName(field.parameter->equalTo));
}

/// Tells whether a field may lie in this vec4: what the functions of curves and ramps read is no
/// field.
bool isReadByField(const ParameterLayout& layout, std::size_t vec4) {
    return std::ranges::none_of(layout.fields, [vec4](const ParameterField& field) {
        const std::size_t first = field.offset / 4;
        return functionOf(field) != nullptr && vec4 >= first &&
               vec4 < first + static_cast<std::size_t>(field.components) / 4;
    });
}

std::string unpackSlots(const Block& block, const UnpackRequest& request) {
    std::string out;
    int place = vec4Count(block);
    for (const Slot& slot : block.slots) {
        const auto fill = std::find_if(request.slots.begin(), request.slots.end(),
                                       [&slot](const SlotFill& f) { return f.kind == slot.kind; });
        if (fill == request.slots.end()) {
            out += fmt::format("    p.{}.unused = 0.0;\n", slot.kind);
            continue;
        }
        out += fmt::format("    p.{} = unpack{}(base + {});\n", slot.kind,
                           slotStructName(slot.kind), place);
        place += fill->vec4s;
    }
    return out;
}

} // namespace

std::string emptySlotSource(std::string_view kind) {
    return fmt::format("struct {} {{\n    float unused;\n}};\n#define {}(at, slot) vec3(0.0)\n",
                       slotStructName(kind), slotFunctionName(kind));
}

std::string slotNamesSource(const Block& block) {
    return fmt::format("#define {} {}\n#define {} {}\n", slotStructName(block.kind),
                       structName(block), slotFunctionName(block.kind), functionName(block));
}

std::string slotStructName(std::string_view kind) {
    return capitalised(kind) + "Slot";
}

std::string slotFunctionName(std::string_view kind) {
    return "slot" + capitalised(kind);
}

std::string unpackedFrom(std::string_view array) {
    return fmt::format("#undef PARAMETER_DATA\n#define PARAMETER_DATA(i) {}[base + (i)]\n", array);
}

int vec4Count(const Block& block) {
    return static_cast<int>(layoutOf(block).floats / 4);
}

std::string constantsSource(const Block& block) {
    std::string out;
    for (const ParameterField& field : layoutOf(block).fields) {
        int index = 0;
        for (const EnumValue& value : choicesOf(field)) {
            out +=
                fmt::format("const int {} = {};\n", constantName(block, field, value.id), index++);
        }
    }
    return out;
}

std::string structSource(const Block& block, std::span<const CompiledValue> compiled) {
    std::string out = fmt::format("struct {} {{\n", structName(block));
    const ParameterLayout layout = layoutOf(block);
    for (const ParameterField& field : layout.fields) {
        out += fmt::format("    {} {};\n", glslType(field), field.name);
        for (const std::string& flag : {equalField(field), plainField(field)}) {
            out += flag.empty() ? "" : fmt::format("    bool {};\n", flag);
        }
    }
    for (const Slot& slot : block.slots) {
        out += fmt::format("    {} {};\n", slotStructName(slot.kind), slot.kind);
    }
    if (layout.fields.empty() && block.slots.empty()) {
        out += "    float unused;\n"; // GLSL has no empty structs
    }
    out += "};\n";
    for (const ParameterField& field : layout.fields) {
        if (functionOf(field) != nullptr) {
            out += isPlain(field, compiled)
                       ? plainFunction(block, field)
                       : std::string(functionOf(field)->before) + functionText(block, field, "int");
        }
    }
    return out;
}

std::string unpackSource(const Block& block, const UnpackRequest& request) {
    const ParameterLayout layout = layoutOf(block);
    std::string defines;
    std::string body;
    for (const ParameterField& field : layout.fields) {
        if (functionOf(field) != nullptr) {
            body += unpackFunction(field, request);
            continue;
        }
        const CompiledValue* compiled = compiledOf(field, request);
        const std::string value =
            compiled == nullptr ? readSource(field) : defineName(field, request);
        body += fmt::format("    p.{} = {};\n", field.name, value);
        if (compiled != nullptr) {
            defines += fmt::format("#define {} {}\n", value, compiledText(block, field, *compiled));
        }
    }
    for (const ParameterField& field : layout.fields) {
        body += equalField(field).empty() ? std::string() : unpackEqual(field, request);
    }
    body += unpackSlots(block, request);
    std::string out = fmt::format("{}{} {}(int base) {{\n    {} p;\n", defines, structName(block),
                                  request.function, structName(block));
    for (std::size_t i = 0; i < layout.floats / 4; ++i) {
        if (isReadByField(layout, i)) {
            out += fmt::format("    vec4 d{} = PARAMETER_DATA({});\n", i, i);
        }
    }
    if (layout.fields.empty() && block.slots.empty()) {
        out += "    p.unused = 0.0;\n";
    }
    return out + body + "    return p;\n}\n";
}

} // namespace patina
