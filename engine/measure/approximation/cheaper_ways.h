// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "measure/approximation/measured_text.h"
#include "predict/gpu_family.h"

namespace patina {

/// Is how many cases that the search did not see judge all of the front; the others judge only what
/// stays of it.
inline constexpr std::size_t casesOfFront = 10000;

/// Says how a search for cheaper ways is made.
struct CheaperSearchOptions {
    const GpuFamily* family = nullptr; ///< is the one that costs are predicted for
    double seconds = 120.0;   ///< is how long it may take; what is not judged by then is left out
    double maxError = 0.25;   ///< leaves out what would be stated as farther off
    std::size_t cases = 1024; ///< counts those that the search judges by
    std::size_t heldOut = 100000; ///< counts those on which the found ways are judged at last
    std::size_t ways = 5;         ///< limits those that are kept of the front
    bool ofValues = false;        ///< judges the subject's own values only, and folds them
    /// Ends the check of the found ways on a graphics device: what is not checked is left out.
    std::function<bool()> isDeviceLate = [] { return false; };
    /// Ends it with an error, without judging what it has found.
    std::function<bool()> isAbandoned = [] { return false; };
};

/// Is a way to compute a block more cheaply.
struct CheaperWay {
    std::vector<ShaderEdit> edits;  ///< are in the order of the text; empty: it is the exact one
    std::vector<std::string> words; ///< say what each of its moves does
    double error = 0.0;             ///< is the largest in any case, as TextError
    double meanError = 0.0;
    double cost = 0.0;
    bool isForValues = false;
    std::optional<BlockTable> table{}; ///< is one that it reads
};

/// Is what a search has found: the front of error and cost.
struct CheaperWays {
    std::shared_ptr<const MeasuredText> text;
    CheaperWay exact;
    std::vector<CheaperWay> ways; ///< are from the most exact to the cheapest
    std::string unit;             ///< is what costs are counted in
    std::size_t moves = 0;        ///< counts the changes that there are to make
    std::size_t tried = 0;        ///< counts the texts that were compiled
    std::size_t heldOut = 0;      ///< counts the cases, unknown to the search, that errors are of
    std::string places;           ///< are those that errors are of (placesInWords())
    std::string sliders;          ///< are the values that errors are of (slidersInWords())
    bool isOfValues = false;      ///< errors are those of the subject's own values only
    /// Are where the ways were found to be farthest off, and where the exact one loses digits.
    std::vector<EvalCase> worst;
    bool isStopped = false;
    Errors notes; ///< say what could not be used, and what to install
};

/// Is told how far a search is; it returns false to end it.
using CheaperProgress = std::function<bool(double share, const CheaperWays& soFar)>;

/// Searches for ways to compute the function of a case more cheaply. Moves are tried by themselves,
/// then together, beginning with what is best so far. Errors are those of float against double
/// precision, costs are predicted. Every way is finite and not negative in edge cases, and its
/// error is the largest on cases that the search did not see, where these lead to by small steps
/// towards larger errors (worstCases()), and in edge cases (statedEdgeCases()) but those in which
/// floats of the exact way lose more than among the others. It is an error where the text does not
/// compile or cannot be evaluated in double precision, where the block has found ways already
/// (whyNotSearched()), or where the search is abandoned.
Checked<CheaperWays> cheaperWays(const EvalCase& subject, const std::filesystem::path& shaders,
                                 const CheaperSearchOptions& options,
                                 const CheaperProgress& progress);

} // namespace patina
