// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "ball_stage.h"
#include "catalog/catalog.h"
#include "gl/program.h"
#include "predict/compile_request.h"
#include "render/gpu/uniform_buffer.h"
#include "shading/program/source_builder.h"

namespace patina::benchmarks {

/// Returns a plain Phong surface in three directional lights.
Scene plainScene(const Catalog& catalog);

/// Returns the models that a formula is behind, which are all but those of measured files.
std::vector<const Block*> modelsByFormula(const Catalog& catalog);

/// Returns the text of a SwitchedProgram.
ProgramText switchedText(const Catalog& catalog, const std::vector<const Block*>& models);

/// Is a program that can draw everything and is told by uniforms what to draw: it is made from the
/// same blocks as the engine's, and selects by a number for the kind where the engine leaves code
/// out. It has the given models, every light, Fresnel term, highlight and fog, ambient light and
/// opacity; it has no images, no shadows and no environment.
class SwitchedProgram {
  public:
    /// Makes the program for the first object of the scene, whose model must be among `models`.
    SwitchedProgram(const Catalog& catalog, const std::vector<const Block*>& models,
                    const Scene& scene, const BallStage& stage);

    void use();

  private:
    std::optional<gl::Program> program_;
    UniformBuffer view_;
    UniformBuffer scene_;
    UniformBuffer object_;
};

} // namespace patina::benchmarks
