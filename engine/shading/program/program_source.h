// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>

#include "core/error.h"
#include "shading/effects/data_layout.h"
#include "shading/effects/effect_set.h"
#include "shading/glsl/shader_source.h"
#include "shading/program/surface_output.h"

namespace patina {

/// The text of a whole program. Uniform blocks are called ViewBlock, SceneBlock and ObjectBlock.
struct ProgramSource {
    ShaderSource vertex;
    ShaderSource fragment;
    std::optional<ShaderSource> geometry{}; ///< what makes lines from the edges of a mesh has one

    /// A name-based UUID (128 bits of SHA-1, by Boost.Uuid) of all texts.
    std::string hash() const;
};

/// The program that draws surfaces with exactly these effects, in canonical order: what is not in
/// the set is not in the text. Errors name files that could not be read. A set without a model has
/// no table of albedos, and one whose levels read no table has no tables. `sceneVec4s` is the size
/// of the scene's block.
Checked<ProgramSource> surfaceProgram(const EffectSet& set, const Catalog& catalog,
                                      SurfaceOutput output = SurfaceOutput::Picture,
                                      int sceneVec4s = SceneLayout::minCapacity);

class SourceBuilder;

/// Adds the text of a stage.
using StageWriter = std::function<void(SourceBuilder&)>;

Checked<ProgramSource> program(const Catalog& catalog, const StageWriter& writeVertex,
                               const StageWriter& writeFragment,
                               const StageWriter& writeGeometry = {});

/// A program that covers the target; `write` adds its fragment stage.
Checked<ProgramSource> screenProgram(const Catalog& catalog, const StageWriter& write);

/// The vertex stage of surfaceProgram(); `work`, of its main, stands behind what places a vertex.
using VertexWork = std::function<std::string(SourceBuilder&)>;
void addSurfaceVertex(SourceBuilder& vertex, const EffectSet& set, const ObjectLayout& layout,
                      const VertexWork& work = {});

/// A program made of files of the shader folder alone.
Checked<ProgramSource> passProgram(const Catalog& catalog, const std::string& vertexFile,
                                   std::span<const std::string> fragmentFiles);

} // namespace patina
