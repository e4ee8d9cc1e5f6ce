// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/shader_names.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <sstream>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "catalog/function_source.h"
#include "catalog/table_source.h"
#include "core/ordinary_file.h"
#include "core/text.h"

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

/// Calls `take(word, rest of the line after it)` for each word before a comment.
template <class Take>
void forEachWord(std::string_view line, const Take& take) {
    line = line.substr(0, line.find("//"));
    while (!line.empty()) {
        const auto first = std::find_if(line.begin(), line.end(), isNameCharacter);
        const auto end = std::find_if_not(first, line.end(), isNameCharacter);
        const auto begins = static_cast<std::size_t>(first - line.begin());
        const auto length = static_cast<std::size_t>(end - first);
        const std::string_view rest = line.substr(begins + length);
        take(line.substr(begins, length), rest);
        line = rest;
    }
}

/// Adds the name that a line of a library file declares. A declaration starts its line; what is
/// inside braces is indented.
void addDeclaration(ShaderNames& names, std::string_view line) {
    if (line.empty() || !isNameCharacter(line.front())) {
        return;
    }
    bool isDone = false;
    forEachWord(line, [&](std::string_view word, std::string_view rest) {
        const bool isNamed = rest.starts_with('(') || rest.starts_with(" {");
        if (isNamed && !isDone && !word.empty()) {
            names.emplace(word);
            isDone = true;
        }
    });
}

void addWords(ShaderNames& names, std::string_view line) {
    forEachWord(line, [&](std::string_view word, std::string_view) {
        if (!word.empty()) {
            names.emplace(word);
        }
    });
}

void addFiles(ShaderNames& names, const fs::path& folder,
              void (*add)(ShaderNames&, std::string_view)) {
    std::error_code status; // a file that cannot be read is reported where it is used
    for (fs::directory_iterator at(folder, status), end; !status && at != end;
         at.increment(status)) {
        std::istringstream file(readFile(at->path(), maxBytes).value_or(std::string()));
        for (std::string line; std::getline(file, line);) {
            add(names, line);
        }
    }
}

} // namespace

ShaderNames shaderNames(const fs::path& shaders) {
    ShaderNames names;
    addFiles(names, shaders / "lib", addDeclaration);
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
