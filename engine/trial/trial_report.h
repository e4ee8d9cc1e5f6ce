// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/error.h"

namespace patina {

/// Represents a line that the process which tries blocks writes: that a trial begins, what is tried
/// once its files are read, or what came of it.
struct TrialReport {
    std::string block; ///< "<kind>/<id>"; empty: no block can be tried on this machine
    bool isDone = false;
    std::string hash{}; ///< of what is tried (see StrangerBlock); empty: it is not read yet
    Errors mistakes{};
};

/// Returns one line of JSON without its end. At most 20 mistakes, with texts of 2000 bytes at most.
std::string toLine(const TrialReport& report);

/// Nothing when the line is something else.
std::optional<TrialReport> trialReport(std::string_view line);

} // namespace patina
