// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/reserved_words.h"

#include <algorithm>
#include <array>

namespace patina {

bool isReservedWord(std::string_view word) {
    constexpr auto words = std::to_array<std::string_view>(
        {"active",    "alignas",  "alignof",   "and",       "asm",       "attribute",  "auto",
         "bool",      "break",    "buffer",    "bvec2",     "bvec3",     "bvec4",      "case",
         "cast",      "catch",    "centroid",  "char",      "class",     "coherent",   "common",
         "concept",   "const",    "continue",  "decltype",  "default",   "delete",     "discard",
         "dmat2",     "dmat3",    "dmat4",     "do",        "double",    "dvec2",      "dvec3",
         "dvec4",     "else",     "enum",      "explicit",  "export",    "extern",     "external",
         "false",     "filter",   "fixed",     "flat",      "float",     "for",        "friend",
         "goto",      "half",     "highp",     "hvec2",     "hvec3",     "hvec4",      "if",
         "image2D",   "in",       "inline",    "inout",     "input",     "int",        "interface",
         "invariant", "ivec2",    "ivec3",     "ivec4",     "layout",    "length",     "long",
         "lowp",      "mat2",     "mat3",      "mat4",      "mediump",   "mutable",    "namespace",
         "new",       "noexcept", "noinline",  "not",       "nullptr",   "operator",   "or",
         "out",       "output",   "partition", "patch",     "precise",   "precision",  "private",
         "protected", "public",   "readonly",  "register",  "requires",  "resource",   "restrict",
         "return",    "sample",   "sampler1D", "sampler2D", "sampler3D", "shared",     "short",
         "signed",    "sizeof",   "smooth",    "static",    "struct",    "subroutine", "superp",
         "switch",    "template", "this",      "throw",     "true",      "try",        "typedef",
         "typename",  "uint",     "uniform",   "union",     "unsigned",  "using",      "uvec2",
         "uvec3",     "uvec4",    "varying",   "vec2",      "vec3",      "vec4",       "virtual",
         "void",      "volatile", "while",     "writeonly", "xor"});
    return std::find(words.begin(), words.end(), word) != words.end();
}

} // namespace patina
