// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <utility>

#include "catalog/block.h"
#include "measure/interpreter/shader_syntax.h"

namespace patina {

/// Knows which expressions of a shader follow from what is compiled into a block's program: choices
/// of its enums and levels of its accuracy choices, which reach other functions as arguments.
class CompiledChoices {
  public:
    /// `syntax` must outlive it.
    CompiledChoices(const ShaderSyntax& syntax, const Block& block);

    /// Tells whether a number without a fraction, or a condition, follows from compiled choices and
    /// constants alone, so that it is the same in all cases of the program.
    bool isChoice(int expression) const;

    /// Tells whether a condition asks for a level that the block's author declared.
    bool asksLevel(int condition) const;

  private:
    using Variable = std::pair<int, std::size_t>; ///< is a function, and a place in its numbers

    const ShaderExpression& at(int index) const {
        return syntax_.expressions[static_cast<std::size_t>(index)];
    }
    bool isField(const ShaderExpression& expression, const std::set<std::string>& names) const;
    void addWrites(const ShaderExpression& expression);
    bool spread(const ShaderExpression& expression);

    const ShaderSyntax& syntax_;
    std::string struct_;
    std::set<std::string> compiled_; ///< are names of fields
    std::set<std::string> levels_;
    std::set<Variable> written_;
    std::set<Variable> varying_; ///< are variables that do not follow from choices
    std::set<Variable> ofLevel_; ///< are variables that a level goes into
};

} // namespace patina
