// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/error.h"

namespace patina {

/// Asks for the polynomial that comes nearest to a function on an interval.
struct PolynomialWish {
    std::string function; ///< is an expression of Sollya in x
    double low = 0.0;
    double high = 1.0;
    int degree = 3;
};

/// Is a polynomial with coefficients that are floats, from the constant one on.
struct FittedPolynomial {
    std::vector<double> coefficients;
    double bound = 0.0; ///< is proved: the difference is nowhere larger, before it is rounded
};

/// Returns what is to be done where Sollya is missing.
inline constexpr const char* installSollya = "apt-get install sollya";

/// Fits polynomials by Sollya's fpminimax, and bounds their errors by its supnorm, in a process of
/// its own. What it finds nothing for, within `seconds` and before `isStopped` says so, is empty.
/// It is an error where Sollya is not installed.
Result<std::vector<std::optional<FittedPolynomial>>>
fittedPolynomials(std::span<const PolynomialWish> wishes, double seconds,
                  const std::function<bool()>& isStopped);

} // namespace patina
