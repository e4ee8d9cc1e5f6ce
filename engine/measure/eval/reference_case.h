// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "measure/eval/eval_case.h"
#include "reference/reference.h"

namespace patina {

/// Points to the double-precision code of a case: that of its block and of what fills its slot.
struct ReferenceCode {
    EvalCase::Subject subject = EvalCase::Subject::Model;
    const reference::Block* block = nullptr;
    const reference::Block* slot = nullptr;     ///< is null where the slot is empty
    const reference::BlockCall* call = nullptr; ///< is null for a function of Directions

    /// Finds the code; an error says which block was added or changed since the program was built.
    static Result<ReferenceCode> find(const EvalCase& request);
};

/// Returns the geometry of a place for a model, with normalised vectors.
reference::Geometry geometryOf(const EvalPlace& place);

/// Holds the results of a case; what is not used is 0.
using ReferenceNumbers = std::array<double, 6>;

/// Evaluates a block, and what fills its slot, with the same packed values at many places.
class ReferenceCase {
  public:
    ReferenceCase(const ReferenceCode& code, std::vector<double> values,
                  std::vector<double> slotValues);
    ReferenceCase(const ReferenceCase&) = delete;
    ReferenceCase& operator=(const ReferenceCase&) = delete;

    /// Returns what the function returns; a model's value has its gates and may be negative.
    ReferenceNumbers evaluate(const EvalPlace& place) const;

    /// Evaluates a model at a geometry that is used as it is, with unit vectors or not.
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
