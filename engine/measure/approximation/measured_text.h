// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <set>
#include <span>
#include <vector>

#include "core/error.h"
#include "measure/approximation/approximation_cases.h"
#include "measure/approximation/shader_edit.h"
#include "measure/eval/eval_source.h"
#include "measure/interpreter/shader_evaluator.h"

namespace patina {

/// Are cases with what the exact text gives there in double precision.
struct JudgedCases {
    CaseTexels texels;
    std::vector<double> exact; ///< are the numbers of one case after the other
};

/// Says how far a text is from the exact one.
struct TextError {
    double worst =
        0.0; ///< of any case, as a share of white, or of the value where that is brighter
    double mean = 0.0;
    bool isSafe = true; ///< nothing is infinite, not a number, or negative where it was not

    bool isWithin(double limit) const { return isSafe && worst <= limit; }
};

/// Tells whether to end an evaluation; it is asked between cases, by several threads.
using EvaluationEnd = std::function<bool()>;

/// Evaluates the text of a block's function, with edits and without.
class MeasuredText {
  public:
    /// Parses the text of a case's program. It is an error where a part of it cannot be evaluated.
    static Checked<MeasuredText> of(const EvalCase& subject, const std::filesystem::path& shaders);

    const ShaderSource& source() const { return *source_; }
    const ShaderSyntax& syntax() const { return *syntax_; }

    /// Are the functions of the block and of the library that only the block's function calls.
    const std::set<int>& ownFunctions() const { return own_; }

    /// Evaluates the exact text in double precision, on all cores, for directions that are unit in
    /// double precision, too. Where it is ended there are no cases.
    JudgedCases judged(CaseTexels texels, const EvaluationEnd& isEnded = {}) const;

    /// Returns the values of all expressions of the exact text in these cases.
    std::vector<ObservedValues> observed(const CaseTexels& texels) const;

    /// Evaluates the text with edits in float and compares it; where `limit` is passed it goes no
    /// further. The error is infinite where the text does not parse; where it is ended it is that
    /// of some of the cases.
    TextError error(std::span<const ShaderEdit> edits, const JudgedCases& cases, double limit,
                    const EvaluationEnd& isEnded = {}) const;

    /// Returns the error of each case, as error() evaluates it, on all cores; infinite where it is
    /// not safe, or it was ended.
    std::vector<double> errors(std::span<const ShaderEdit> edits, const JudgedCases& cases,
                               const EvaluationEnd& isEnded = {}) const;

    /// Evaluates the text in float, and these of its expressions in floats of 16 bits, and compares
    /// it; where `limit` is passed it goes no further.
    TextError errorInHalf(const std::vector<bool>& halved, const JudgedCases& cases,
                          double limit) const;

    /// Evaluates the text in float, and these of its expressions in floats of 16 bits; returns the
    /// numbers of one case after the other.
    std::vector<double> valuesInHalf(const std::vector<bool>& halved,
                                     const CaseTexels& texels) const;

    /// Marks the expressions of the block's own functions whose values are floats.
    std::vector<bool> ownFloats() const;

    /// Tells whether all numbers of cases are finite, and none negative that must not be, where
    /// that holds for the exact text.
    bool isSafe(std::span<const ShaderEdit> edits, const JudgedCases& cases,
                const EvaluationEnd& isEnded = {}) const;

    /// Returns the error of a case's numbers.
    double errorOf(std::span<const double> exact, std::span<const double> got) const;

    std::size_t results() const { return shape_.results; }

  private:
    MeasuredText() = default;
    void evaluate(ShaderEvaluator& evaluator, int function, const std::vector<double>& texels,
                  std::span<double> results) const;
    bool isSafe(std::span<const double> exact, std::span<const double> got) const;
    TextError compared(ShaderEvaluator& evaluator, int function, const JudgedCases& cases,
                       double limit, const EvaluationEnd& isEnded) const;

    std::unique_ptr<ShaderSource> source_;
    std::unique_ptr<ShaderSyntax> syntax_;
    EvalShape shape_;
    std::size_t signed_ = 0; ///< counts the first numbers, which may be below 0
    bool isCut_ = false;     ///< a value below 0 is drawn as 0
    std::set<int> own_;
};

} // namespace patina
