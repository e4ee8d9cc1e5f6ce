// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "measure/eval/eval_case.h"

namespace patina {

/// Are the numbers of cases as a program reads them, which are floats (placeTexels() and
/// valueTexels()).
using CaseTexels = std::vector<std::vector<double>>;

/// Says which cases are made of a subject.
struct CaseWish {
    std::size_t count = 1024;
    std::uint32_t seed = 1;    ///< of the directions
    std::size_t firstRow = 0;  ///< of the sets of values that a slider reaches (ordinaryRows())
    std::size_t rows = 32;     ///< counts these; every fourth case has the subject's own values
    bool hasOwnValues = false; ///< all cases have the subject's own values
    bool reachesEnds = false;  ///< every other set of values is at ends of sliders in half of them
};

/// Returns cases with light and viewer anywhere above the surface, a third of them near the mirror
/// direction, and for other kinds anything that is common.
std::vector<EvalCase> commonCases(const EvalCase& subject, const CaseWish& wish);

/// Returns about `count` cases where formulas break: those of the stability sweep, thinned out.
std::vector<EvalCase> edgeCases(const EvalCase& subject, std::size_t count, bool hasOwnValues);

CaseTexels texelsOfCases(const std::vector<EvalCase>& cases);

} // namespace patina
