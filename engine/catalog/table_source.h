// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "catalog/block.h"

namespace patina {

/// "modelTerms" for the table "terms" of `model`: what the block calls, `vec3 f(vec2 x, Model p)`,
/// x in 0 .. 1 along each axis. The block's own text defines what an entry is, by a function of
/// that name and "Entry".
std::string tableFunction(const Block& block, const BlockTable& table);
std::string entryFunction(const Block& block, const BlockTable& table);

/// The function's declaration, which stands before the block's text.
std::string tableDeclaration(const Block& block, const BlockTable& table);

/// The function computed on demand, without any table: the mean of the entries around x, linear
/// along each axis, so that it errs as the table does. GLSL that is C++ where float is read as
/// double; it stands behind the block's text.
std::string computedTable(const Block& block, const BlockTable& table);

/// Returns the same of all tables of a block.
std::string tableDeclarations(const Block& block);
std::string computedTables(const Block& block);

} // namespace patina
