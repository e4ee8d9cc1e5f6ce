// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "gl/program.h"
#include "gl/vertex_array.h"
#include "measure/eval/eval_source.h"

namespace patina {

/// A program that answers many cases with the same key in one draw. Its context must be current
/// whenever it is made, used or destroyed.
class EvalProgram {
  public:
    /// Cases of one draw; what one drawing takes in memory stays in the tens of megabytes.
    static constexpr std::size_t largestDraw = 1u << 16;

    /// `shaders` is the folder that holds lib/ and passes/.
    static Result<EvalProgram> link(const EvalCase& request, const std::filesystem::path& shaders);

    const EvalShape& shape() const { return shape_; }

    /// The results of `count` <= largestDraw cases, shape().results each, as the shader gave them:
    /// a model's value may be negative. `texels` holds 4 * shape().caseTexels numbers of each case.
    Result<std::vector<float>> draw(std::vector<float> texels, std::size_t count) const;

  private:
    EvalProgram(gl::Program program, const EvalShape& shape);

    gl::Program program_;
    EvalShape shape_;
    gl::VertexArray vertices_;
};

} // namespace patina
