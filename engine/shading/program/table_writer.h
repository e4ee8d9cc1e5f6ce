// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "shading/program/surface_output.h"
#include "shading/program/table_layout.h"

namespace patina {

/// Tells whether the program reads tables of the block from the texture (passes/block_tables.glsl);
/// other outputs than a picture compute the entries they need.
bool looksUp(const Block& block, const TableLayout& tables, SurfaceOutput output);

/// Return the text to put before and after a block's own, so that it can call its tables. Tables
/// that the program does not read become macros that need no entry and no texture.
std::string textBeforeBlock(const Block& block, const TableLayout& tables, SurfaceOutput output);
std::string textBehindBlock(const Block& block, const TableLayout& tables, SurfaceOutput output);

/// Writes the output and main() of a program that fills the texture: each entry at its place.
/// `Model` and the unpack functions of all that reads a table must be declared before.
std::string fillingSource(const TableLayout& tables);

} // namespace patina
