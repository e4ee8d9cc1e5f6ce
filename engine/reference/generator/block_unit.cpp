// SPDX-License-Identifier: GPL-3.0-or-later
#include "block_unit.h"

#include <algorithm>
#include <span>

#include <fmt/format.h>

#include "catalog/function_source.h"
#include "catalog/parameter_layout.h"
#include "catalog/table_source.h"
#include "core/text.h"
#include "declarations.h"
#include "number_mover.h"
#include "reference/reference.h"

namespace patina {
namespace {

constexpr std::string_view directions = "Directions";

/// Tells whether a function takes Directions. Such functions have a signature of their own, since
/// only they have slots.
bool isOfDirections(const BlockFunction& function) {
    return function.argument == directions;
}

/// Tells whether the block's own text has a function.
bool isDeclared(const Block& block, const BlockFunction& wanted, const Declarations& own) {
    std::vector<std::string> types;
    if (!wanted.argument.empty()) {
        types.emplace_back(wanted.argument);
    }
    types.push_back(structName(block));
    const std::string name = functionName(block) + std::string(wanted.suffix);
    return std::ranges::any_of(own.functions, [&](const FunctionDeclaration& function) {
        return function.name == name && function.result == wanted.result &&
               std::ranges::equal(function.arguments, types, {},
                                  [](const auto& argument) { return std::string(argument.type); });
    });
}

/// Returns the functions of a block that are called with numbers or Directions: those of its kind,
/// and those of a Fresnel block that its own text has beside them.
std::vector<BlockFunction> functionsOf(const Block& block, const Declarations& own) {
    const BlockKind* kind = findKind(block.kind);
    std::vector<BlockFunction> all;
    if (kind != nullptr) {
        all.assign(kind->functions.begin(), kind->functions.end());
    }
    const BlockFunction optional[] = {{reference::indicesSuffix, "vec3"},
                                      {reference::acrossSuffix, "vec3", "Incidence", "i"}};
    for (const BlockFunction& each : optional) {
        if (block.kind == kinds::fresnel && isDeclared(block, each, own)) {
            all.push_back(each);
        }
    }
    return all;
}

const std::vector<EnumValue>* choicesOf(const ParameterField& field) {
    if (field.choice != nullptr) {
        return &field.choice->values;
    }
    return infoOf(field.parameter->type).isChoice ? &field.parameter->values : nullptr;
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
    return std::string(infoOf(field.parameter->type).cpp);
}

std::string unpackedField(const ParameterField& field) {
    if (functionOf(field) != nullptr) {
        const std::string plain = plainField(field);
        return fmt::format("    p.{} = &data[{}];\n", field.name, field.offset) +
               (plain.empty() ? ""
                              : fmt::format("    p.{} = data[{}] == 0.0;\n", plain, field.offset));
    }
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

/// Returns the block's struct, its constants and the function that fills it from packed values.
std::string structCode(const Block& block, const ParameterLayout& layout) {
    std::string constantLines;
    std::string fields;
    std::string unpacked;
    std::string functions;
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
        if (functionOf(field) != nullptr) {
            const std::string plain = plainField(field);
            fields += plain.empty() ? "" : fmt::format("    bool {}{{}};\n", plain);
            functions += asCpp(functionText(block, field, "const double*"));
        }
    }
    for (const Slot& slot : block.slots) {
        fields += fmt::format("    {}Slot {};\n", capitalised(slot.kind), slot.kind);
    }
    return fmt::format("{0}\nstruct {1} {{\n{2}}};\n\n"
                       "{1} unpack([[maybe_unused]] Parameters data) {{\n    {1} p;\n{3}"
                       "    return p;\n}}\n\n{4}",
                       constantLines, structName(block), fields, unpacked, functions);
}

/// Returns the statements that call what fills a slot; a function of Directions gets the slot's
/// geometry.
std::string slotCall(const BlockFunction& function, const Declarations& declarations) {
    if (isOfDirections(function)) {
        return "    return slot.filler->block->model(*slot.geometry, slot.filler->parameters, "
               "{});\n";
    }
    const std::string type(function.argument);
    const std::string result(function.result);
    NumberMover out(declarations, Language::Cpp);
    NumberMover in(declarations, Language::Cpp);
    return fmt::format("    double out[{}] = {{}};\n    {}\n    double in[{}] = {{}};\n"
                       "    slot.filler->block->calls[0].call(out, in, slot.filler->parameters);\n"
                       "    {} value{{}};\n    {}\n    return value;\n",
                       declarations.numbers(type), out.write(type, std::string(function.name)),
                       declarations.numbers(result), cppType(result), in.read(result, "value"));
}

/// Returns the functions by which a model uses its slots. They must follow the library, since they
/// need its structs.
std::string slotCode(const Block& block, const Declarations& declarations) {
    std::string code;
    for (const Slot& slot : block.slots) {
        const BlockKind* kind = findKind(slot.kind);
        if (kind == nullptr || kind->functions.empty()) {
            continue;
        }
        const BlockFunction& function = kind->functions.front();
        code += fmt::format("using {1}Slot = FilledSlot;\n"
                            "{0} slot{1}([[maybe_unused]] {2} {3}, {1}Slot slot) {{\n"
                            "    if (slot.filler == nullptr) {{\n        return {0}(0.0);\n    }}\n"
                            "{4}}}\n",
                            function.result, capitalised(slot.kind), function.argument,
                            function.name, slotCall(function, declarations));
    }
    return code;
}

/// Returns the name of the function to which a block's table points.
std::string callName(std::string_view suffix) {
    return "call" + std::string(suffix);
}

/// Returns a function that calls the block's function of Directions with this suffix.
std::string directionsCall(const Block& block, std::string_view suffix) {
    std::string slots;
    for (const Slot& slot : block.slots) {
        slots += fmt::format("    p.{0} = filledSlot(fillers, \"{0}\", g);\n", slot.kind);
    }
    return fmt::format("vec3 {0}(const Geometry& g, Parameters data,\n"
                       "         [[maybe_unused]] Fillers fillers) {{\n"
                       "    {1} p = unpack(data);\n{2}"
                       "    Directions d = directions(g.n, g.t, g.b, g.l, g.v);\n"
                       "    d.pixel = g.pixel;\n    return vec3({3}{4}(d, p));\n}}\n",
                       callName(suffix), structName(block), slots, functionName(block), suffix);
}

/// Returns a function that reads the argument from numbers, calls the block's function and writes
/// its result as numbers.
std::string numbersCall(const Block& block, const BlockFunction& function,
                        const Declarations& declarations) {
    NumberMover in(declarations, Language::Cpp);
    NumberMover out(declarations, Language::Cpp);
    const std::string argument(function.argument);
    const std::string result(function.result);
    const std::string before = argument.empty()
                                   ? ""
                                   : fmt::format("    {} argument{{}};\n    {}\n",
                                                 cppType(argument), in.read(argument, "argument"));
    return fmt::format("void {}([[maybe_unused]] const double* in, double* out,\n"
                       "          [[maybe_unused]] Parameters data) {{\n{}"
                       "    const {} result = {}{}({}unpack(data));\n    {}\n}}\n",
                       callName(function.suffix), before, cppType(result), functionName(block),
                       function.suffix, argument.empty() ? "" : "argument, ",
                       out.write(result, "result"));
}

/// Returns the suffixes of functions by which a model tells factors of its highlight.
std::vector<std::string_view> factorsOf(const Block& block, const Declarations& own) {
    std::vector<std::string_view> found;
    for (const std::string_view suffix : reference::factorSuffixes) {
        const std::string name = functionName(block) + std::string(suffix);
        const bool isThere =
            block.kind == kinds::models &&
            std::ranges::any_of(own.functions, [&](const FunctionDeclaration& function) {
                return function.name == name && function.arguments.size() == 2 &&
                       function.arguments[0].type == directions &&
                       function.arguments[1].type == structName(block) &&
                       (function.result == "float" || function.result == "vec3");
            });
        if (isThere) {
            found.push_back(suffix);
        }
    }
    return found;
}

/// Returns C++ that lists a field of the struct p number by number.
std::string numbersOf(const ParameterField& field) {
    if (field.components == 1) {
        return fmt::format("double(p.{})", field.name);
    }
    std::string text;
    for (int i = 0; i < field.components; ++i) {
        text += fmt::format("{}p.{}[{}]", i == 0 ? "" : ", ", field.name, i);
    }
    return text;
}

/// Returns the look-up of a table, before it the entries that it takes: cached, since the cases of
/// one set of values look near the same ones.
std::string cachedTable(const Block& block, const BlockTable& table,
                        const ParameterLayout& layout) {
    std::string numbers;
    int count = 0;
    for (const ParameterField& field : layout.fields) {
        if (field.parameter != nullptr && std::ranges::count(table.of, field.parameter->id) != 0) {
            numbers += fmt::format("{}{}", count == 0 ? "" : ", ", numbersOf(field));
            count += field.components;
        }
    }
    const std::string computed = entryFunction(block, table);
    const std::string cached = tableFunction(block, table) + "CachedEntry";
    return fmt::format("vec3 {0}(vec2 x, {1} p) {{\n"
                       "    static thread_local EntryCache<{2}> cache({3}, {4});\n"
                       "    return cache.at(x, {{{5}}}, [&] {{ return {6}(x, p); }});\n}}\n{7}",
                       cached, structName(block), count, table.size.x, table.size.y, numbers,
                       computed, asCpp(computedTable(block, table, cached)));
}

std::string cachedTables(const Block& block, const ParameterLayout& layout) {
    std::string code;
    for (const BlockTable& table : block.tables) {
        code += cachedTable(block, table, layout);
    }
    return code;
}

/// Returns the functions to which the block's table points.
std::string entryFunctions(const Block& block, const Declarations& declarations,
                           const std::vector<BlockFunction>& functions,
                           const std::vector<std::string_view>& factors) {
    std::string code;
    for (const std::string_view suffix : factors) {
        code += directionsCall(block, suffix);
    }
    for (const BlockFunction& function : functions) {
        code += isOfDirections(function) ? directionsCall(block, function.suffix)
                                         : numbersCall(block, function, declarations);
    }
    return code;
}

std::string entryAssignments(const std::vector<BlockFunction>& functions,
                             const Declarations& declarations) {
    std::string rows;
    std::string model;
    for (const BlockFunction& function : functions) {
        if (isOfDirections(function)) {
            model = fmt::format("    block.model = &{};\n", callName(function.suffix));
            continue;
        }
        rows += fmt::format("        BlockCall{{\"{}\", {}, {}, &{}}},\n", function.suffix,
                            declarations.numbers(std::string(function.argument)),
                            declarations.numbers(std::string(function.result)),
                            callName(function.suffix));
    }
    return rows.empty() ? model
                        : fmt::format("{}    static constexpr BlockCall calls[] = {{\n{}"
                                      "    }};\n    block.calls = calls;\n",
                                      model, rows);
}

std::string factorAssignments(const std::vector<std::string_view>& factors) {
    std::string rows;
    for (const std::string_view suffix : factors) {
        rows += fmt::format("        ModelFactor{{\"{}\", &{}}},\n", suffix, callName(suffix));
    }
    return rows.empty() ? rows
                        : fmt::format("    static constexpr ModelFactor factors[] = {{\n{}"
                                      "    }};\n    block.factors = factors;\n",
                                      rows);
}

std::string entry(const Block& block, const ParameterLayout& layout,
                  const Declarations& declarations, const std::vector<BlockFunction>& functions,
                  const std::vector<std::string_view>& factors) {
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
                       block.hasGate("view"), table,
                       entryAssignments(functions, declarations) + factorAssignments(factors));
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
    const Declarations declarations = declarationsOf(plainText(library));
    const std::string ownText = plainText(code);
    const Declarations ownDeclarations = declarationsOf(ownText);
    const auto functions = functionsOf(block, ownDeclarations);
    const auto factors = factorsOf(block, ownDeclarations);
    return fmt::format("#include \"reference/elementary.h\"\n#include \"reference/entry_cache.h\"\n"
                       "#include \"reference/glsl.h\"\n\n"
                       "namespace patina::reference::{0} {{\n\n{1}\n#line 1 \"generated\"\n"
                       "{2}{3}\n{7}{4}\n#line 1 \"generated\"\n{8}{5}\n{6}\n"
                       "}} // namespace patina::reference::{0}\n",
                       unitScope(block), asCpp(library), slotCode(block, declarations),
                       structCode(block, layout), asCpp(code),
                       entryFunctions(block, declarations, functions, factors),
                       entry(block, layout, declarations, functions, factors),
                       tableDeclarations(block), cachedTables(block, layout));
}

std::string emptyUnit(const Block& block) {
    return fmt::format("// No code: {} are not compiled in double precision.\n"
                       "namespace patina::reference::{} {{}}\n",
                       block.kind, unitScope(block));
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
