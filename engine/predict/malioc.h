// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "core/error.h"
#include "predict/compile_request.h"

namespace patina {

/// Says how `malioc` is run, which is ARM's Mali Offline Compiler.
struct MaliocRun {
    std::vector<std::string> arguments;
    std::size_t memoryBytes = 0; ///< limits its data
    double seconds = 0.0;        ///< ends it after so long
};

/// Runs the `malioc` that PATH has and returns the report that it prints with "--format json". It
/// is an error where there is none, it takes longer, or it prints something else.
Result<nlohmann::json> maliocReport(MaliocRun run);

/// Returns the names of the cores that the `malioc` in PATH compiles for, such as "Mali-G78"; none
/// where it is missing or does not tell.
std::set<std::string> maliocCores();

/// Returns "Mali Offline Compiler 8.5.0" of one of its reports.
std::string maliocName(const nlohmann::json& report);

/// Returns what a report of a compiled stage says. Cycles are those of a core for 64 lanes, in the
/// pipeline that takes longest, on the longest path; where loops run unknown times there is none,
/// then each instruction is counted once. It is an error where the stage was not compiled, with
/// malioc's words.
Result<StageStatistics> maliocStage(const nlohmann::json& report);

} // namespace patina
