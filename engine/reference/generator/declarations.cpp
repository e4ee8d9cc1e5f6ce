// SPDX-License-Identifier: GPL-3.0-or-later
#include "declarations.h"

#include <map>

#include "shading/glsl/glsl_declarations.h"

namespace patina {
namespace {

std::vector<Variable> named(const std::vector<GlslVariable>& variables) {
    std::vector<Variable> result;
    for (const GlslVariable& variable : variables) {
        result.push_back({std::string(variable.type), std::string(variable.name), variable.isOut});
    }
    return result;
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
    const GlslTokens tokens = glslTokens(text);
    Declarations declarations;
    for (const GlslStruct& each : structsIn(tokens)) {
        declarations.structs.push_back({std::string(each.name), named(each.fields)});
    }
    for (const GlslFunction& each : functionsIn(tokens)) {
        declarations.functions.push_back(
            {std::string(each.result), std::string(each.name.text), named(each.arguments)});
    }
    return declarations;
}

} // namespace patina
