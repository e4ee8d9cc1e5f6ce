// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/catalog.h"
#include "scene/scene.h"
#include "shading/program/program_source.h"

namespace patina {

/// Returns a scene in which the block is called, with its defaults; beside it there are blocks that
/// ship.
Scene trialScene(const Block& block, const Catalog& catalog);

/// Returns a small program that calls what the block is called by, whatever a document shows and,
/// but of what fills a slot, even where its defaults call for nothing: to learn what a compiler
/// says of it. Errors are those of files that cannot stand in a program.
Checked<ProgramSource> trialProgram(const Block& block, const Catalog& catalog);

} // namespace patina
