// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/shader_names.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "catalog/function_source.h"
#include "catalog/table_source.h"
#include "core/ordinary_file.h"
#include "shading/glsl/glsl_declarations.h"
#include "shading/glsl/tokens.h"

namespace patina {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t maxBytes = 1u << 20; // limits the size of a file of these folders

/// Tells whether GLSL has a function of this name. A function of the same name would hide all of
/// its overloads, whatever the arguments.
bool isFunctionOfGlsl(std::string_view name) {
    constexpr auto names = std::to_array<std::string_view>(
        {"abs",           "acos",         "acosh",         "all",           "any",
         "asin",          "asinh",        "atan",          "atanh",         "barrier",
         "ceil",          "clamp",        "cos",           "cosh",          "cross",
         "degrees",       "determinant",  "distance",      "dot",           "equal",
         "exp",           "exp2",         "faceforward",   "floor",         "fma",
         "fract",         "frexp",        "fwidth",        "greaterThan",   "greaterThanEqual",
         "inverse",       "inversesqrt",  "isinf",         "isnan",         "ldexp",
         "length",        "lessThan",     "lessThanEqual", "log",           "log2",
         "max",           "min",          "mix",           "mod",           "modf",
         "noise1",        "noise2",       "noise3",        "noise4",        "normalize",
         "notEqual",      "outerProduct", "pow",           "radians",       "reflect",
         "refract",       "round",        "roundEven",     "shadow1D",      "shadow2D",
         "sign",          "sin",          "sinh",          "smoothstep",    "sqrt",
         "step",          "tan",          "tanh",          "texelFetch",    "texelFetchOffset",
         "texture",       "texture1D",    "texture2D",     "texture3D",     "textureCube",
         "textureGather", "textureGrad",  "textureLod",    "textureOffset", "textureProj",
         "textureSize",   "transpose",    "trunc"});
    return std::find(names.begin(), names.end(), name) != names.end();
}

using AddNames = void (*)(ShaderNames&, const GlslTokens&);

void addDeclarations(ShaderNames& names, const GlslTokens& tokens) {
    for (const GlslFunction& function : functionsIn(tokens)) {
        names.emplace(function.name.text);
    }
    for (const GlslStruct& declared : structsIn(tokens)) {
        names.emplace(declared.name);
    }
}

void addWords(ShaderNames& names, const GlslTokens& tokens) {
    for (const GlslToken& token : opened(tokens)) {
        if (token.isName()) {
            names.emplace(token.text);
        }
    }
}

void addFiles(ShaderNames& names, const fs::path& folder, AddNames add) {
    std::error_code status; // a file that cannot be read is reported where it is used
    for (fs::directory_iterator at(folder, status), end; !status && at != end;
         at.increment(status)) {
        const std::string text =
            withoutComments(readFile(at->path(), maxBytes).value_or(std::string()));
        add(names, glslTokens(text));
    }
}

} // namespace

ShaderNames shaderNames(const fs::path& shaders) {
    ShaderNames names;
    addFiles(names, shaders / "lib", addDeclarations);
    addFiles(names, shaders / "passes", addWords);
    return names;
}

Errors nameMistakes(const Descriptor& descriptor, const ShaderNames& taken) {
    Errors errors;
    std::vector<std::string> names{structName(descriptor.block), functionName(descriptor.block)};
    for (const BlockTable& table : descriptor.block.tables) {
        names.push_back(tableFunction(descriptor.block, table));
        names.push_back(entryFunction(descriptor.block, table));
    }
    for (const Parameter& parameter : descriptor.block.parameters) {
        if (infoOf(parameter.type).function != nullptr) {
            names.push_back(functionOfField(descriptor.block, fieldName(parameter.id)));
        }
    }
    for (const std::string& name : names) {
        if (errors.empty() && (isFunctionOfGlsl(name) || taken.contains(name))) {
            errors.push_back(descriptor.document.error(
                "/id",
                fmt::format("the id \"{}\" makes the name \"{}\", which is taken by {}",
                            descriptor.block.id, name,
                            isFunctionOfGlsl(name) ? "GLSL" : "Patina's own shaders"),
                "another id"));
        }
    }
    return errors;
}

} // namespace patina
