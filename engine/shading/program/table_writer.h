// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "shading/program/surface_output.h"
#include "shading/program/table_layout.h"

namespace patina {

/// Tells whether the program looks tables of the block up (passes/block_tables.glsl); other outputs
/// than a picture compute the entries they need.
bool looksUp(const Block& block, const TableLayout& tables, SurfaceOutput output);

/// Returns what stands before a block's text and behind it, so that it can call its tables. Those
/// that the program does not read are macros that no entry and no texture belongs to.
std::string textBeforeBlock(const Block& block, const TableLayout& tables, SurfaceOutput output);
std::string textBehindBlock(const Block& block, const TableLayout& tables, SurfaceOutput output);

/// Declares what a program that fills the texture writes, and its main(): each entry where it
/// lies. `Model` and the unpack functions of all that reads a table are there.
std::string fillingSource(const TableLayout& tables);

} // namespace patina
