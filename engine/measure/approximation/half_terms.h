// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "measure/approximation/measured_text.h"

namespace patina {

/// Is a line of a block's text, with what becomes of the block's value where the operations on this
/// line alone have floats of 16 bits.
struct HalfLine {
    std::string file; ///< is relative to the folder of the blocks, as "models/phong.glsl"
    int line = 0;     ///< is 1-based
    std::string code; ///< is the line without the spaces around it
    TextError error;
    double largest = 0.0; ///< is the largest magnitude on it, in double precision

    bool holds(double limit) const { return error.isWithin(limit); }
};

/// Says which of a block's lines can be computed with floats of 16 bits.
struct HalfReport {
    std::vector<HalfLine> lines;       ///< are in the order of the text
    TextError whole;                   ///< is that with all lines in 16 bits
    TextError mixed;                   ///< is that with those of `together`
    std::vector<std::size_t> together; ///< are indices of lines that hold also all at once
    double limit = 0.0;                ///< is the error up to which a line holds
    std::size_t cases = 0;
    std::shared_ptr<const MeasuredText> text{};
    std::shared_ptr<const JudgedCases> common{}; ///< are those that errors are of
    std::shared_ptr<const JudgedCases> edge{};   ///< are those where values must stay finite
    /// Tell for each line which of the text's expressions stand on it.
    std::vector<std::vector<bool>> marks{};

    /// Returns the expressions that stand on some of the lines, as halfEdits() takes them.
    std::vector<bool> halvedBy(const std::vector<std::size_t>& some) const;

    /// Returns the error with those expressions in 16 bits.
    TextError errorOf(const std::vector<bool>& halved) const;
};

/// Is told which share of the work is done, by one thread at a time; it returns false to end it.
using HalfProgress = std::function<bool(double share)>;

/// Evaluates a block's function on the CPU, each operation of some lines rounded to 16 bits and the
/// others to float, in common cases and in edge cases. A line holds where the value stays finite
/// and as far from double precision as `limit`, in any channel where white is 1, relative above.
/// It is an error where the text does not compile or cannot be evaluated, or it is ended.
Checked<HalfReport> halfReport(const EvalCase& subject, const std::filesystem::path& shaders,
                               bool hasOwnValues, double limit, const HalfProgress& progress);

} // namespace patina
