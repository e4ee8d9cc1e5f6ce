// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/catalog.h"
#include "material/material.h"
#include "shading/program/program_source.h"

namespace patina {

/// A small program that calls what the block is called by, whatever a document shows: to learn what
/// a compiler says of it. The block has its defaults; beside it there are blocks that ship. Errors
/// are those of files that cannot stand in a program.
Checked<ProgramSource> trialProgram(const Block& block, const Catalog& catalog);

/// A material that has the block where its kind is a material's, and is plain otherwise.
Material trialMaterial(const Block& block, const Catalog& catalog);

/// The block where it is a light, else one that casts shadows; null where none ships.
const Block* trialLight(const Block& block, const Catalog& catalog);

} // namespace patina
