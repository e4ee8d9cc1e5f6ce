// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
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

/// Returns cases with light and viewer anywhere above the surface, rays of fog of any direction and
/// up to 1 km long, and for other kinds anything that is common. Of four surfaces three are turned
/// anywhere and one has the normal z, along which cosines have nothing to round. Of 16 directions
/// one is near the normal and one near the lowest, of 12 viewers 4 are near the mirror direction
/// and one near the light, each at an angle of any size. What is found, what it is judged by and
/// what tries its stated error are drawn so, by different seeds.
std::vector<EvalCase> commonCases(const EvalCase& subject, const CaseWish& wish);

/// Returns about `count` cases where formulas break: those of the stability sweep, thinned out.
std::vector<EvalCase> edgeCases(const EvalCase& subject, std::size_t count, bool hasOwnValues);

/// Returns about `count` edge cases of those places for which errors are stated, with values that
/// sliders reach: at places that no drawn case meets, as at a ray that is exactly level, a formula
/// may have a branch of its own.
std::vector<EvalCase> statedEdgeCases(const EvalCase& subject, std::size_t count,
                                      bool hasOwnValues);

/// Returns cases in which one or two of light, viewer and values are a little elsewhere, or far, as
/// commonCases() may have them.
std::vector<EvalCase> nearbyCases(const EvalCase& from, std::size_t count, bool hasOwnValues,
                                  std::uint32_t seed);

/// Says in words which places commonCases() has: "light and viewer 3 degrees or more above the
/// surface".
std::string placesInWords(const EvalCase& subject);

/// Says in words which values commonCases() has, of those parameters whose sliders do not reach all
/// that may be typed: "Shininess from 1 to 1000". Empty where all values are reached.
std::string slidersInWords(const EvalCase& subject);

CaseTexels texelsOfCases(const std::vector<EvalCase>& cases);

} // namespace patina
