// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "shading/effects/data_layout.h"
#include "shading/effects/effect_set.h"
#include "shading/program/program_source.h"

namespace patina {

/// The array `objectData` of the program that draws outlines.
struct OutlineLayout {
    static constexpr int line = 0; ///< x, y: a pixel of the picture in clip space; z: what nears a
                                   ///< point to the eye by as much as it is wide there
    static constexpr int fixed = 1; ///< the block's values follow

    BlockPlace block;

    int vec4s() const { return fixed + block.vec4s(); }
};

/// Points into the catalogue's block; nothing where the set has no outline.
std::optional<OutlineLayout> outlineLayout(const EffectSet& set, const Catalog& catalog);

/// The program that draws the lines of a set with an outline. It reads edges (GpuEdges) and knows
/// of the scene only its fog.
Checked<ProgramSource> outlineProgram(const EffectSet& set, const Catalog& catalog,
                                      int sceneVec4s = SceneLayout::minCapacity);

} // namespace patina
