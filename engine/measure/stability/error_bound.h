// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "measure/eval/reference_case.h"

namespace patina {

/// Tells how far a float result may be from the double-precision one on the same float inputs:
/// (16 noise + 32 * 2^-24) |value| + 1e-30. noise |value| is the change of the exact value when its
/// inputs move by half a unit in the last place of a float: the sum of the changes as each moves in
/// turn, or, where that is larger, the change as all move together, or as light and viewer move
/// towards mirror directions, where a lobe may be narrower than a rounding. A move is 2^-24 for a
/// cosine and for each component of the unit vectors that a model is given (whose lengths are
/// therefore not exactly 1, as in the shader), and 2^-24 of itself for a point, a distance, a
/// parameter, and, for a model without a direction of brushing, a component along a normal of
/// (0, 0, 1): such a cosine is exact, however small. Choices and whole numbers do not move.
class ErrorBound {
  public:
    /// Takes the code of a case, and the case, which must outlive the bound.
    ErrorBound(const ReferenceCode& code, const EvalCase& request);

    /// Returns the bound of each number at this place. `exact` must be bound.evaluate(place).
    ReferenceNumbers at(const ReferenceCase& bound, const EvalPlace& place,
                        const ReferenceNumbers& exact) const;

    /// Returns the largest error of an answer over its bound. The noise is computed only until it
    /// covers the error; the result is then at most 1, and relative to that part of the bound.
    double excess(const ReferenceCase& bound, const EvalPlace& place, const ReferenceNumbers& exact,
                  const ReferenceNumbers& answer) const;

    /// Returns the part of the bound that does not depend on the noise.
    static double floor(double exact);

    /// Tells whether the noise that is known so far is enough. More computation can only add to it.
    using Enough = std::function<bool(const ReferenceNumbers&)>;

  private:
    ReferenceNumbers noise(const ReferenceCase& bound, const EvalPlace& place,
                           const ReferenceNumbers& exact, const Enough& enough) const;
    ReferenceNumbers limits(const ReferenceNumbers& noise, const ReferenceNumbers& exact) const;

    ReferenceCode code_;
    const EvalCase& request_;
};

} // namespace patina
