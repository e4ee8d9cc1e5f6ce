// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "core/value.h"

namespace patina {

/// Is a condition over parameters: `distribution == ggx and not (roughness.x <= 0.5)`.
///
/// Operands are parameter ids, numbers, true, false, and the ids of enum values, bare or quoted;
/// operators are == != < <= > >=, `and`, `or`, `not` and parentheses. A lone operand holds when it
/// is true or not zero. Comparing things of different kinds is false (and true for !=).
class Expression {
  public:
    /// Parses a text; the empty one is always true. An error has line 1 and the column in the text.
    static Result<Expression> parse(std::string_view text);

    bool evaluate(const Values& values) const;

    /// Is a comparison of two words; what each means depends on the parameters of the block.
    struct Comparison {
        std::string left;
        std::string right; ///< is empty when the operand stands alone
    };

    /// Returns all comparisons, for checking the words against a block's parameters.
    std::vector<Comparison> comparisons() const;

  private:
    struct Node;
    std::shared_ptr<const Node> root_; ///< is immutable, so that copies may share it
};

} // namespace patina
