// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "catalog/catalog.h"
#include "shading/effects/data_layout.h"
#include "shading/effects/effect_set.h"
#include "shading/program/program_source.h"
#include "shading/program/surface_output.h"

namespace patina {

/// Returns the program that draws surfaces with exactly these effects, in canonical order: what is
/// not in the set is not in the text. Errors name files that could not be read. A set without a
/// model has no table of albedos, and one whose levels read no table has no tables. `sceneVec4s` is
/// the size of the scene's block.
Checked<ProgramSource> surfaceProgram(const EffectSet& set, const Catalog& catalog,
                                      SurfaceOutput output = SurfaceOutput::Picture,
                                      int sceneVec4s = SceneLayout::minCapacity);

/// Returns the program that draws the strands of a set with fins on edges of the mesh (GpuEdges).
/// Its data are those of the program for the picture.
Checked<ProgramSource> finsProgram(const EffectSet& set, const Catalog& catalog,
                                   int sceneVec4s = SceneLayout::minCapacity);

/// Returns the program that draws the marks of a set's strokes, a rectangle for each (GpuMarks).
/// Its data are those of the program for the picture.
Checked<ProgramSource> marksProgram(const EffectSet& set, const Catalog& catalog,
                                    int sceneVec4s = SceneLayout::minCapacity);

/// Holds the vertex stage of surfaceProgram(); `work`, of its main, stands behind what places a
/// vertex.
using VertexWork = std::function<std::string(SourceBuilder&)>;
void addSurfaceVertex(SourceBuilder& vertex, const EffectSet& set, const ObjectLayout& layout,
                      const VertexWork& work = {}, SurfaceOutput output = SurfaceOutput::Picture);

} // namespace patina
