// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "catalog/block.h"

namespace patina {

/// Returns the name of the function that the block calls for a table, "modelTerms" for the table
/// "terms" of `model`: `vec3 f(vec2 x, Model p)`, x in 0 .. 1 along each axis. The block's own text
/// defines what an entry is, by a function of that name and "Entry".
std::string tableFunction(const Block& block, const BlockTable& table);
std::string entryFunction(const Block& block, const BlockTable& table);

/// Returns the function's declaration, which precedes the block's text.
std::string tableDeclaration(const Block& block, const BlockTable& table);

/// Returns the function as it is computed on demand, without any table: the mean of the entries
/// around x, linear along each axis, so that its error is that of the table. It is GLSL that is
/// also C++ where float means double; it follows the block's text. `entry` is called for entries in
/// place of the block's own function.
std::string computedTable(const Block& block, const BlockTable& table);
std::string computedTable(const Block& block, const BlockTable& table, const std::string& entry);

/// Returns the declarations, or the functions, of all tables of a block.
std::string tableDeclarations(const Block& block);
std::string computedTables(const Block& block);

} // namespace patina
