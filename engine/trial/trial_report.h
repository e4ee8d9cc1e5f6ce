// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/error.h"

namespace patina {

/// Holds one line of the process which tries blocks: that a trial begins, which hash the block has
/// once its files are read, or the result.
struct TrialReport {
    std::string block; ///< is "<kind>/<id>"; empty: no block can be tried on this machine
    bool isDone = false;
    std::string hash{}; ///< is StrangerBlock::hash of what is tried; empty: not read yet
    Errors mistakes{};
};

/// Returns the report as one line of JSON without a line break. It has at most 20 mistakes, whose
/// texts are cut at 2000 bytes.
std::string toLine(const TrialReport& report);

/// Reads such a line; nothing is returned where the line is something else.
std::optional<TrialReport> trialReport(std::string_view line);

} // namespace patina
