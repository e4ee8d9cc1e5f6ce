// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "measure/eval/eval_case.h"
#include "reference/reference.h"

namespace patina {

/// Holds the double-precision code of a case: of its block and of what fills its slot.
struct ReferenceCode {
    EvalCase::Subject subject = EvalCase::Subject::Model;
    const reference::Block* block = nullptr;
    const reference::Block* slot = nullptr;     ///< null when the block has none
    const reference::BlockCall* call = nullptr; ///< null of a function of Directions

    /// The error says which block was added or changed since the program was built.
    static Result<ReferenceCode> find(const EvalCase& request);
};

/// Returns where a model is evaluated at a place, its vectors normalised.
reference::Geometry geometryOf(const EvalPlace& place);

/// Holds the numbers that answer a case; what is not used is 0.
using ReferenceNumbers = std::array<double, 6>;

/// Represents a block and what fills its slot with packed values, ready to be evaluated at many
/// places.
class ReferenceCase {
  public:
    ReferenceCase(const ReferenceCode& code, std::vector<double> values,
                  std::vector<double> slotValues);
    ReferenceCase(const ReferenceCase&) = delete;
    ReferenceCase& operator=(const ReferenceCase&) = delete;

    /// Returns what the function returns; a model's value with its gates and not cut at 0.
    ReferenceNumbers evaluate(const EvalPlace& place) const;

    /// Returns the same for a model about a geometry that is taken as it is, unit vectors or not.
    ReferenceNumbers evaluate(const reference::Geometry& geometry) const;

    const std::vector<double>& values() const { return values_; }
    const std::vector<double>& slotValues() const { return slotValues_; }

  private:
    ReferenceCode code_;
    std::vector<double> values_;
    std::vector<double> slotValues_;
    reference::Filler filler_;
};

} // namespace patina
