// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "measure/interpreter/shader_syntax.h"

namespace patina {

/// Is a term with all that leads to it, as the body of a function of the block's values and a few
/// numbers.
struct SlicedTerm {
    /// Is a number that the term depends on besides the block's values.
    struct Variable {
        std::string text; ///< is its expression where the term stands
        std::string name; ///< is its name in `entry` and `term`
        int expression = -1;
    };
    int expression = -1;
    std::vector<Variable> variables;
    std::set<std::string> fields; ///< are those of the block's values that are read, by name
    std::string parameters;       ///< is the name of the block's values where the term stands
    std::string place;            ///< is a name that nothing in `entry` and `term` has
    std::string entry;            ///< are statements, in which the block's values are `p`
    std::string term;             ///< is the expression behind them
    /// Are the statements of the function that nothing needs but the term, and where they stand.
    std::vector<int> removed;
    std::vector<std::pair<std::size_t, std::size_t>> removedText;
};

/// Says where the numbers are on which a term depends.
enum class TermLeaves {
    Operands, ///< they are arguments of the function that the term calls
    Near,     ///< they are variables that the term reads
    Far       ///< they are arguments of the function that the term stands in, as far as can be
};

/// Cuts terms out of functions: of the statements before a term those that lead to it.
class FunctionSlicer {
  public:
    /// `parameters` is the name of the struct of the block's values. `syntax` must outlive it.
    FunctionSlicer(const ShaderSyntax& syntax, std::string parameters);
    ~FunctionSlicer();
    FunctionSlicer(const FunctionSlicer&) = delete;
    FunctionSlicer& operator=(const FunctionSlicer&) = delete;

    /// Returns an expression with what leads to it; nothing where it depends on what is no number,
    /// or its function has not the block's values.
    std::optional<SlicedTerm> slice(int expression, TermLeaves leaves);

  private:
    class Flow;
    const Flow& flowOf(int function);

    const ShaderSyntax& syntax_;
    std::string parameters_;
    std::map<int, std::unique_ptr<Flow>> flows_;
};

} // namespace patina
