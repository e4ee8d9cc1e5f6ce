// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "ball_stage.h"
#include "catalog/catalog.h"
#include "gl/program.h"

namespace patina::benchmarks {

/// Is a program of the files in minimal/, written by hand for one model and one surrounding: a
/// main() with its lights one after the other, and a uniform for each value by its name. It uses
/// nothing of the engine's shaders but functions of shaders/lib.
class MinimalProgram {
  public:
    /// Takes the names of the files: "phong" and "studio" for minimal/phong.glsl and
    /// minimal/studio.frag.
    MinimalProgram(const Catalog& catalog, const std::string& model,
                   const std::string& surrounding, const Scene& scene, const BallStage& stage);

    void use() const { program_->use(); }

  private:
    void setUniforms(const Catalog& catalog, const Scene& scene, const BallStage& stage);

    std::optional<gl::Program> program_;
    std::string name_;
};

} // namespace patina::benchmarks
