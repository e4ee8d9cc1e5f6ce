// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "declarations.h"
#include "glsl_text.h"

namespace patina {

/// Holds what a generated file of library functions holds.
struct LibraryUnit {
    std::string function;  ///< that gives the table: "functions"
    std::string scope;     ///< inner namespace of the shader code
    std::string code;      ///< C++ to compile, may be empty when headers have it
    std::string more;      ///< C++ after the table, in the outer namespace
    Declarations callable; ///< the structs and the functions that the table lists
};

/// Returns the C++ file: the code, a wrapper that turns numbers into arguments for each function,
/// and the table of them, sorted by name.
std::string librarySource(const LibraryUnit& unit);

} // namespace patina
