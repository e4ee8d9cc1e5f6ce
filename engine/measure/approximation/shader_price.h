// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "measure/approximation/shader_edit.h"
#include "measure/eval/eval_case.h"
#include "predict/compile_request.h"
#include "predict/gpu_family.h"

namespace patina {

/// Returns the function that reads a block's table from a texture, `tableFunction()`, in a text
/// that has passes/block_tables.glsl.
std::string readingCode(const Block& block, const BlockTable& table);

/// Predicts what a block's function costs with edits: cycles of a family of graphics cards for 64
/// pixels, or, where the driver that predicts them is missing, instructions, of which one that
/// takes longer counts four times. The projections of light and viewer (Directions) are in every
/// price, and tables are read from a texture, as in the programs that draw.
class ShaderPrice {
  public:
    /// What it refers to must outlive it.
    ShaderPrice(const EvalCase& subject, const ShaderSource& source, const ShaderSyntax& syntax,
                const GpuFamily& family);

    /// Returns the price with each of these edits; nothing where that does not compile.
    std::vector<std::optional<double>> of(const std::vector<std::vector<ShaderEdit>>& ways,
                                          const std::function<bool()>& isStopped);

    /// Returns the program that is priced: arguments of a case differ from pixel to pixel, by its
    /// uniforms casePlaces, and its values are the uniforms caseValues.
    ProgramText programOf(const std::vector<ShaderEdit>& edits) const;

    /// Says what is counted: "cycles of RDNA 2 for 64 pixels" or "instructions".
    std::string unit() const;

    /// Says why instructions are counted instead of cycles; empty where they are not.
    const std::string& note() const { return note_; }

  private:
    const ShaderSource& source_;
    const ShaderSyntax& syntax_;
    const GpuFamily& family_;
    std::size_t places_ = 1; ///< counts the vec4s of a case's arguments
    std::size_t values_ = 1; ///< counts those of its values
    std::vector<ShaderEdit> frame_;
    bool counts_ = false;
    std::string note_;
};

} // namespace patina
