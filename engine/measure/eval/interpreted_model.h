// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "measure/eval/eval_case.h"
#include "measure/interpreter/shader_evaluator.h"
#include "shading/glsl/shader_source.h"

namespace patina {

/// Is the error of a model whose evaluation does not end.
Error endlessError(const Block& model);

/// Evaluates a model in double precision from the text of its program, so that a model needs no
/// compiled code for it. It may be called by several threads.
class InterpretedModel {
  public:
    /// Reads and parses the program of a case; the last few that were parsed are kept. It is an
    /// error where the text cannot be evaluated, at its place, and where it does not end.
    static Result<std::shared_ptr<const InterpretedModel>> of(const EvalCase& model,
                                                              const std::filesystem::path& shaders);

    /// Returns what the model returns for the numbers of a case (placeNumbers(), valueNumbers());
    /// nothing where that does not end.
    std::optional<glm::dvec3> evaluate(std::span<const double> numbers) const;

  private:
    /// Tells whether the model ends for light and viewer in some directions.
    bool ends(EvalCase model) const;

    InterpretedModel(std::unique_ptr<const ShaderSource> source, ShaderSyntax syntax);

    std::unique_ptr<const ShaderSource> source_; ///< has the text to which the syntax refers
    ShaderSyntax syntax_;
    int function_ = -1;
    mutable std::mutex guard_;
    /// Are those that no thread uses.
    mutable std::vector<std::unique_ptr<ShaderEvaluator>> idle_;
};

} // namespace patina
