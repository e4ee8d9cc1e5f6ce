// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "measure/approximation/cheap_moves.h"
#include "measure/approximation/sollya.h"

namespace patina {

/// Is a part of a shader that depends on one number: how it follows from that number in the range
/// that really occurs.
struct OneVariableTerm {
    int expression = -1;
    std::string variable; ///< is the number for a replacement, which keeps it
    double low = 0.0;
    double high = 1.0;
    double min = 0.0; ///< is the smallest value
    /// Is an expression of Sollya in x = 0 .. 1 along the range: a polynomial through many points.
    std::string function;
    double residual = 0.0;       ///< is how far that may be from the term
    bool isProportional = false; ///< is 0 at 0, and `function` is what it is over the number
};

/// Finds the terms of one variable. Those that no polynomial follows, because they bend or jump,
/// are left out.
std::vector<OneVariableTerm> oneVariableTerms(const ShaderSource& source,
                                              const ObservedShader& shader);

/// Returns moves that put polynomials of several degrees in the place of terms. It is an error
/// where Sollya is missing.
Result<std::vector<CheapMove>> polynomialMoves(const ObservedShader& shader,
                                               std::span<const OneVariableTerm> terms,
                                               double seconds,
                                               const std::function<bool()>& isStopped);

} // namespace patina
