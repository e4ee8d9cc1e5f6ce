// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "declarations.h"
#include "glsl_text.h"

namespace patina {

/// Holds what librarySource() puts into a generated file of library functions.
struct LibraryUnit {
    std::string function;  ///< is the one that returns the table: "functions"
    std::string scope;     ///< is the inner namespace of the shader code
    std::string code;      ///< is C++ to compile; empty where headers have it
    std::string more;      ///< is C++ after the table, in the outer namespace
    Declarations callable; ///< has the structs, and the functions that the table lists
};

/// Returns the C++ file: the code, a wrapper for each function that makes arguments of numbers, and
/// the table of them, sorted by name.
std::string librarySource(const LibraryUnit& unit);

} // namespace patina
