// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "measure/eval/reference_case.h"

namespace patina {

/// Tells how far a float result may be from the double-precision one on the same float inputs:
/// (16 noise + 32 * 2^-24) |value| + 1e-30. noise |value| is what the exact value changes by when
/// its inputs move by half a unit in the last place of a float: the sum of the changes as each
/// moves in turn, or, where that is larger, the change as all move together, or as light and viewer
/// move towards mirror directions, where a lobe may be narrower than a rounding. That is 2^-24 for
/// a cosine and for each component of the unit vectors that a model is given (whose lengths are
/// therefore not exactly 1, as in the shader), and 2^-24 of itself for a point, a distance, a
/// parameter, and a component along a normal that is (0, 0, 1) where no grain matters: such a
/// cosine is exact, however small. What is a choice or a whole number does not move.
class ErrorBound {
  public:
    /// `request` says what the values mean; it must outlive the bound.
    ErrorBound(const ReferenceCode& code, const EvalCase& request);

    /// Returns the bound of each number at this place. `exact` is bound.evaluate(place).
    ReferenceNumbers at(const ReferenceCase& bound, const EvalPlace& place,
                        const ReferenceNumbers& exact) const;

    /// Returns how many times its bound the largest error of an answer is. The noise is looked at
    /// only until what is known of it covers the error: of that part the answer is then, at most 1.
    double excess(const ReferenceCase& bound, const EvalPlace& place, const ReferenceNumbers& exact,
                  const ReferenceNumbers& answer) const;

    /// Returns what is allowed without looking at the noise.
    static double floor(double exact);

    /// Tells whether the noise that is known so far says all that is asked; more only adds to it.
    using Enough = std::function<bool(const ReferenceNumbers&)>;

  private:
    ReferenceNumbers noise(const ReferenceCase& bound, const EvalPlace& place,
                           const ReferenceNumbers& exact, const Enough& enough) const;
    ReferenceNumbers limits(const ReferenceNumbers& noise, const ReferenceNumbers& exact) const;

    ReferenceCode code_;
    const EvalCase& request_;
};

} // namespace patina
