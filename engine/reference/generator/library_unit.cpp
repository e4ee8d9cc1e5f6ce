// SPDX-License-Identifier: GPL-3.0-or-later
#include "library_unit.h"

#include <algorithm>

#include <fmt/format.h>

namespace patina {
namespace {

std::string cppType(const std::string& type) {
    return type == "float" ? "double" : type;
}

enum class Language { Cpp, Glsl };

/// Statements that move values between variables and a row of numbers, one place after the other.
class Mover {
  public:
    Mover(const Declarations& declarations, Language language)
        : declarations_(declarations), language_(language) {}

    std::string read(const std::string& type, const std::string& place) {
        return move(type, place, true);
    }
    std::string write(const std::string& type, const std::string& place) {
        return move(type, place, false);
    }

  private:
    std::string move(const std::string& type, const std::string& place, bool reading) {
        std::string text;
        if (const StructDeclaration* declared = declarations_.findStruct(type)) {
            for (const Variable& field : declared->fields) {
                text += move(field.type, place + '.' + field.name, reading);
            }
            return text;
        }
        const std::size_t count = declarations_.numbers(type);
        if (count == 1) {
            return scalar(type, place, reading);
        }
        for (std::size_t i = 0; i < count; ++i) {
            text += scalar("float", fmt::format("{}[{}]", place, i), reading);
        }
        return text;
    }

    std::string scalar(const std::string& type, const std::string& place, bool reading) {
        const std::size_t at = cursor_++;
        const bool cpp = language_ == Language::Cpp;
        if (!reading) {
            return cpp ? fmt::format("out[{}] = double({}); ", at, place)
                       : fmt::format("RESULT({}, float({})); ", at, place);
        }
        return cpp ? fmt::format("{} = {}(in[{}]); ", place, cppType(type), at)
                   : fmt::format("{} = {}(ARGUMENT({})); ", place, type, at);
    }

    const Declarations& declarations_;
    Language language_;
    std::size_t cursor_ = 0;
};

/// Statements that read the arguments, call the function and write its results.
std::string callOf(const Declarations& declarations, const FunctionDeclaration& function,
                   Language language) {
    const auto type = [language](const std::string& name) {
        return language == Language::Cpp ? cppType(name) : name;
    };
    Mover in(declarations, language);
    Mover out(declarations, language);
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
