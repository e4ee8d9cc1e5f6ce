// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/function_source.h"

#include <fmt/format.h>

#include "core/text.h"

namespace patina {
namespace {

std::string signatureOf(const Block& block, const ParameterField& field) {
    return fmt::format("{} {}({} x, {} p) {{\n", functionOf(field)->result,
                       functionOfField(block, field.name), functionOf(field)->argument,
                       structName(block));
}

} // namespace

const ShaderFunction* functionOf(const ParameterField& field) {
    return field.parameter == nullptr ? nullptr : infoOf(field.parameter->type).function;
}

std::string functionOfField(const Block& block, const std::string& field) {
    return functionName(block) + capitalised(field);
}

std::string plainField(const ParameterField& field) {
    const ShaderFunction* function = functionOf(field);
    return function == nullptr || function->plainWord.empty()
               ? std::string()
               : field.name + capitalised(function->plainWord);
}

std::string functionText(const Block& block, const ParameterField& field, std::string_view base) {
    const std::string plain = plainField(field);
    return fmt::format("{}{}    {} base = p.{};\n{}}}\n", signatureOf(block, field),
                       plain.empty() ? ""
                                     : fmt::format("    if (p.{}) {{\n    {}    }}\n", plain,
                                                   functionOf(field)->plainBody),
                       base, field.name, functionOf(field)->body);
}

std::string plainFunction(const Block& block, const ParameterField& field) {
    return fmt::format("{}{}}}\n", signatureOf(block, field), functionOf(field)->plainBody);
}

} // namespace patina
