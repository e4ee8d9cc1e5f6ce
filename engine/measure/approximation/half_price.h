// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "measure/approximation/half_terms.h"
#include "predict/gpu_family.h"

namespace patina {

/// Is what a block's function is predicted to take with some of its lines in floats of 16 bits, in
/// cycles for 64 pixels, with the geometry of light and viewer.
struct HalfPrice {
    const GpuFamily* family = nullptr;
    std::optional<double> inFloat;
    std::optional<double> together; ///< is that of all lines that hold at once
    /// Are those of them that are cheapest, as indices of lines; none where floats are.
    std::vector<std::size_t> lines;
    std::optional<double> cheapest;
    TextError error;  ///< is that of the cheapest
    std::string note; ///< says why the compiler could not be asked; empty where it could
};

/// Predicts that for a family: for halves of the lines that hold at once, quarters and so on to
/// each by itself, and for all but these; then lines of the cheapest set are left out one by one,
/// as often as the number of lines can be halved. So n lines take n log n programs at most. Prices
/// are empty where the family's compiler has no floats of 16 bits or is missing; where it is ended
/// they are those found so far.
HalfPrice halfPrice(const EvalCase& subject, const HalfReport& report, const GpuFamily& family,
                    const HalfProgress& progress);

} // namespace patina
