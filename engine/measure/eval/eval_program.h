// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "gl/program.h"
#include "gl/vertex_array.h"
#include "measure/eval/eval_source.h"
#include "render/gpu/measured_store.h"

namespace patina {

/// Evaluates many cases with the same key in one draw of a program. Its context must be current
/// whenever it is made, used or destroyed.
class EvalProgram {
  public:
    /// Limits the cases of one draw, so that it needs only tens of megabytes of memory.
    static constexpr std::size_t largestDraw = 1u << 16;

    /// Compiles and links the program of a case. `shaders` is the folder with lib/ and passes/. The
    /// error is the compiler's first one.
    static Result<EvalProgram> link(const EvalCase& request, const std::filesystem::path& shaders);

    const EvalShape& shape() const { return shape_; }

    /// Binds the table of the measured file that a case names, where its block has one; the next
    /// draw() reads it.
    static void bindMeasured(MeasuredStore& store, const EvalCase& request);

    /// Returns the results of `count` <= largestDraw cases, shape().results each, as the shader
    /// gave them: a model's value may be negative. `texels` holds 4 * shape().caseTexels numbers of
    /// each case.
    Result<std::vector<float>> draw(std::vector<float> texels, std::size_t count) const;

  private:
    EvalProgram(gl::Program program, const EvalShape& shape);

    gl::Program program_;
    EvalShape shape_;
    gl::VertexArray vertices_;
};

} // namespace patina
