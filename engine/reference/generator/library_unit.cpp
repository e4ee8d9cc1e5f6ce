// SPDX-License-Identifier: GPL-3.0-or-later
#include "library_unit.h"

#include <algorithm>

#include <fmt/format.h>

#include "number_mover.h"

namespace patina {
namespace {

/// Returns statements that read the arguments, call the function and write its results.
std::string callOf(const Declarations& declarations, const FunctionDeclaration& function,
                   Language language) {
    const auto type = [language](const std::string& name) {
        return language == Language::Cpp ? cppType(name) : name;
    };
    NumberMover in(declarations, language);
    NumberMover out(declarations, language);
    std::string before;
    std::string arguments;
    std::string after;
    if (function.result != "void") {
        after += out.write(function.result, "value_");
    }
    for (const Variable& argument : function.arguments) {
        const std::string name = argument.name + '_';
        before += fmt::format("{} {}; ", type(argument.type), name);
        before += argument.out ? "" : in.read(argument.type, name);
        after += argument.out ? out.write(argument.type, name) : "";
        arguments += (arguments.empty() ? "" : ", ") + name;
    }
    const std::string target =
        function.result == "void" ? "" : type(function.result) + " value_ = ";
    return fmt::format("{}{}{}({}); {}", before, target, function.name, arguments, after);
}

std::string wrapper(const Declarations& declarations, const FunctionDeclaration& function) {
    return fmt::format(
        "void call_{}([[maybe_unused]] const double* in, double* out) {{\n    {}\n}}\n\n",
        function.name, callOf(declarations, function, Language::Cpp));
}

std::string tableEntry(const std::string& scope, const Declarations& declarations,
                       const FunctionDeclaration& function) {
    std::size_t arguments = 0;
    std::size_t results = declarations.numbers(function.result);
    for (const Variable& argument : function.arguments) {
        (argument.out ? results : arguments) += declarations.numbers(argument.type);
    }
    return fmt::format("    {{\"{}\", \"{}\", {}, {}, &{}::call_{},\n     \"{}\"}},\n",
                       function.name, function.signature(), arguments, results, scope,
                       function.name, callOf(declarations, function, Language::Glsl));
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
