// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "catalog/catalog.h"
#include "gl/program.h"
#include "shading/effects/data_layout.h"
#include "shading/effects/effect_set.h"

namespace patina {

/// Holds the programs of a material with the layouts of their data. It keeps the catalogue that it
/// was made from, so that it can still draw after the blocks have changed.
struct Pipeline {
    std::shared_ptr<const Catalog> catalog;
    EffectSet effects;
    ObjectLayout object;
    SceneLayout scene;
    std::uint64_t sceneKey = 0;
    std::shared_ptr<const gl::Program> program;
    std::shared_ptr<const gl::Program> tableProgram; ///< fills the tables that `program` reads;
                                                     ///< null without any
    std::shared_ptr<const gl::Program> lobeSamples;  ///< draws what the lobes are fitted to; null
                                                     ///< without a fit
    std::shared_ptr<const gl::Program> lobeFit;      ///< fits the lobes; null without a fit
    std::shared_ptr<const gl::Program> lobeTable;    ///< makes the table of the lobes; null without
                                                     ///< a fit
    std::optional<OutlineLayout> outline; ///< is that of outlineProgram; empty without outlines
    std::shared_ptr<const gl::Program> outlineProgram;
    std::shared_ptr<const gl::Program> finsProgram; ///< draws strands on edges, with the data of
                                                    ///< `program`; null without fins
    std::shared_ptr<const gl::Program> marksProgram; ///< draws the marks of strokes, with the data
                                                     ///< of `program`; null without strokes
};

} // namespace patina
