// SPDX-License-Identifier: GPL-3.0-or-later
#include "library_unit.h"

#include <algorithm>

#include <fmt/format.h>

namespace patina {
namespace {

std::string cppType(const std::string& type) {
    return type == "float" ? "double" : type;
}

/// Statements that move a value between its variable and the array `array` at `cursor`.
class Mover {
  public:
    Mover(const Declarations& declarations, std::string array)
        : declarations_(declarations), array_(std::move(array)) {}

    std::string read(const std::string& type, const std::string& place) {
        return move(type, place, true);
    }
    std::string write(const std::string& type, const std::string& place) {
        return move(type, place, false);
    }

  private:
    std::string move(const std::string& type, const std::string& place, bool reading) {
        if (const StructDeclaration* declared = declarations_.findStruct(type)) {
            std::string text;
            for (const Variable& field : declared->fields) {
                text += move(field.type, place + '.' + field.name, reading);
            }
            return text;
        }
        const std::size_t count = declarations_.numbers(type);
        if (count == 1) {
            return scalar(type, place, reading);
        }
        std::string text;
        for (std::size_t i = 0; i < count; ++i) {
            text += scalar("float", fmt::format("{}[{}]", place, i), reading);
        }
        return text;
    }

    std::string scalar(const std::string& type, const std::string& place, bool reading) {
        const std::size_t at = cursor_++;
        if (!reading) {
            return fmt::format("    {}[{}] = static_cast<double>({});\n", array_, at, place);
        }
        if (type == "bool") {
            return fmt::format("    {} = {}[{}] != 0.0;\n", place, array_, at);
        }
        return fmt::format("    {} = static_cast<{}>({}[{}]);\n", place, cppType(type), array_, at);
    }

    const Declarations& declarations_;
    std::string array_;
    std::size_t cursor_ = 0;
};

std::string wrapper(const Declarations& declarations, const FunctionDeclaration& function) {
    Mover in(declarations, "in");
    Mover out(declarations, "out");
    std::string body;
    std::string call;
    std::string results;
    for (const Variable& argument : function.arguments) {
        const std::string name = argument.name + '_';
        body += fmt::format("    {} {}{{}};\n", cppType(argument.type), name);
        body += argument.out ? "" : in.read(argument.type, name);
        call += (call.empty() ? "" : ", ") + name;
    }
    if (function.result != "void") {
        results += out.write(function.result, "value");
    }
    for (const Variable& argument : function.arguments) {
        results += argument.out ? out.write(argument.type, argument.name + '_') : "";
    }
    return fmt::format("void call_{0}([[maybe_unused]] const double* in, double* out) {{\n"
                       "{1}    {2}{0}({3});\n{4}}}\n\n",
                       function.name, body,
                       function.result == "void" ? "" : "const auto value = ", call, results);
}

std::string tableEntry(const std::string& scope, const Declarations& declarations,
                       const FunctionDeclaration& function) {
    std::size_t arguments = 0;
    std::size_t results = declarations.numbers(function.result);
    for (const Variable& argument : function.arguments) {
        (argument.out ? results : arguments) += declarations.numbers(argument.type);
    }
    return fmt::format("    {{\"{}\", \"{}\", {}, {}, &{}::call_{}}},\n", function.name,
                       function.signature(), arguments, results, scope, function.name);
}

} // namespace

std::string librarySource(const LibraryUnit& unit) {
    std::vector<FunctionDeclaration> functions = unit.callable.functions;
    std::sort(functions.begin(), functions.end(),
              [](const auto& a, const auto& b) { return a.name < b.name; });
    std::string wrappers;
    std::string table;
    for (const FunctionDeclaration& function : functions) {
        wrappers += wrapper(unit.callable, function);
        table += tableEntry(unit.scope, unit.callable, function);
    }
    return fmt::format("#include \"reference/elementary.h\"\n#include \"reference/glsl.h\"\n\n"
                       "namespace patina::reference {{\nnamespace {0} {{\n\n{1}\n"
                       "#line 1 \"generated\"\n{2}}} // namespace {0}\n\n"
                       "std::span<const Function> {3}() {{\n"
                       "    static constexpr Function table[] = {{\n{4}    }};\n"
                       "    return table;\n}}\n\n{5}}} // namespace patina::reference\n",
                       unit.scope, unit.code, wrappers, unit.function, table, unit.more);
}

} // namespace patina
