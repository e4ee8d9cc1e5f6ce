// SPDX-License-Identifier: GPL-3.0-or-later
#include "declarations.h"

#include <map>
#include <regex>

namespace patina {
namespace {

/// The text with the insides of all braces left out, so that only what stands at the top level is
/// left ("struct" bodies excepted, which `structsOf` reads from the whole text).
std::string topLevel(const std::string& text) {
    std::string result;
    int depth = 0;
    for (const char c : text) {
        depth -= c == '}' ? 1 : 0;
        if (depth == 0) {
            result += c;
        }
        depth += c == '{' ? 1 : 0;
    }
    return result;
}

Variable variableOf(const std::string& text) {
    static const std::regex form(R"(\s*(?:OUT\(\s*(\w+)\s*\)|(\w+))\s+(\w+)\s*)");
    std::smatch match;
    if (!std::regex_match(text, match, form)) {
        return {};
    }
    return {match[1].matched ? match[1] : match[2], match[3], match[1].matched};
}

std::vector<Variable> variablesOf(const std::string& list, char separator) {
    std::vector<Variable> variables;
    std::size_t start = 0;
    while (start < list.size()) {
        const std::size_t end = std::min(list.find(separator, start), list.size());
        if (Variable variable = variableOf(list.substr(start, end - start));
            !variable.name.empty()) {
            variables.push_back(std::move(variable));
        }
        start = end + 1;
    }
    return variables;
}

std::vector<StructDeclaration> structsOf(const std::string& text) {
    static const std::regex form(R"(\bstruct\s+(\w+)\s*\{([^}]*)\})");
    std::vector<StructDeclaration> structs;
    for (std::sregex_iterator it(text.begin(), text.end(), form), end; it != end; ++it) {
        structs.push_back({(*it)[1], variablesOf((*it)[2], ';')});
    }
    return structs;
}

std::vector<FunctionDeclaration> functionsOf(const std::string& text) {
    static const std::regex form(R"(\b(\w+)\s+(\w+)\s*\(((?:OUT\(\w+\)|[^()])*)\)\s*\{)");
    const std::string outside = topLevel(text);
    std::vector<FunctionDeclaration> functions;
    for (std::sregex_iterator it(outside.begin(), outside.end(), form), end; it != end; ++it) {
        functions.push_back({(*it)[1], (*it)[2], variablesOf((*it)[3], ',')});
    }
    return functions;
}

} // namespace

std::string FunctionDeclaration::signature() const {
    std::string text = result + ' ' + name + '(';
    for (const Variable& argument : arguments) {
        text += text.back() == '(' ? "" : ", ";
        text += argument.out ? "OUT(" + argument.type + ") " : argument.type + ' ';
        text += argument.name;
    }
    return text + ')';
}

const StructDeclaration* Declarations::findStruct(const std::string& name) const {
    for (const StructDeclaration& candidate : structs) {
        if (candidate.name == name) {
            return &candidate;
        }
    }
    return nullptr;
}

std::size_t Declarations::numbers(const std::string& type) const {
    static const std::map<std::string, std::size_t> plain{{"float", 1}, {"int", 1},  {"bool", 1},
                                                          {"vec2", 2},  {"vec3", 3}, {"vec4", 4}};
    if (const auto found = plain.find(type); found != plain.end()) {
        return found->second;
    }
    std::size_t sum = 0;
    if (const StructDeclaration* declared = findStruct(type)) {
        for (const Variable& field : declared->fields) {
            sum += numbers(field.type);
        }
    }
    return sum;
}

Declarations declarationsOf(const std::string& text) {
    return {structsOf(text), functionsOf(text)};
}

} // namespace patina
