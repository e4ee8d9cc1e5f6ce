// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/catalog.h"
#include "shading/effects/effect_set.h"
#include "shading/glsl/source_builder.h"
#include "shading/program/program_source.h"

namespace patina {

/// Declares the environment: its data, its block, `unpackEnvironment(int base)` and
/// `environmentRadiance(vec3 d, Environment p)`.
void addEnvironment(SourceBuilder& out, const Block& block, const BlockUse& use);

/// What an environment's own programs draw.
enum class EnvironmentOutput {
    Small,            ///< the small picture that its table is made from
    SharpBackground,  ///< what is seen behind the objects
    BlurredBackground ///< the same out of focus
};

/// A program that covers the target. The uniform block is called EnvironmentBlock.
Checked<ProgramSource> environmentProgram(const Block& block, const BlockUse& use,
                                          const Catalog& catalog, EnvironmentOutput output);

} // namespace patina
