// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "catalog/block.h"
#include "glsl_text.h"

namespace patina {

/// Returns the name of the generated file: "models-cook-torrance.cpp".
std::string unitFile(const Block& block);
/// Returns the namespace of what the generated file declares.
std::string unitScope(const Block& block);

/// Returns the C++ file of one block: its struct, constants, shader code and entry for the table.
/// `lines` are the block's file and what it includes.
std::string blockSource(const Block& block, const GlslLines& lines);

/// Returns the C++ file of a block whose kind is not compiled in double precision, which has no
/// code: the build expects a file for every block.
std::string emptyUnit(const Block& block);

/// Returns the C++ file with the table of all blocks.
std::string registrySource(const std::vector<Block>& blocks);

} // namespace patina
