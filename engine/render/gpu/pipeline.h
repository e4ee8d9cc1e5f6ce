// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "catalog/catalog.h"
#include "gl/program.h"
#include "shading/effects/data_layout.h"
#include "shading/effects/effect_set.h"

namespace patina {

/// Represents a program (two where there are outlines) with what is needed to feed it. It keeps the
/// catalogue it was made from, so that it can be drawn with after the blocks have changed.
struct Pipeline {
    std::shared_ptr<const Catalog> catalog;
    EffectSet effects;
    ObjectLayout object;
    SceneLayout scene;
    std::uint64_t sceneKey = 0;
    std::shared_ptr<const gl::Program> program;
    std::shared_ptr<const gl::Program> tableProgram; ///< fills the tables that it reads, if any
    std::shared_ptr<const gl::Program> lobeSamples;  ///< what its lobes are fitted to, if they are
    std::shared_ptr<const gl::Program> lobeFit;      ///< what fits them,
    std::shared_ptr<const gl::Program> lobeTable;    ///< and what makes the table of them
    std::optional<OutlineLayout> outline; ///< of the program that draws its lines, where it has any
    std::shared_ptr<const gl::Program> outlineProgram;
};

} // namespace patina
