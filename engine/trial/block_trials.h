// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "trial/trial_report.h"

namespace patina {

/// Says which blocks a process tries and where they are.
struct TrialRequest {
    std::filesystem::path shaders;   ///< is the folder of the blocks that ship
    std::filesystem::path own;       ///< is the folder of the user's blocks
    std::vector<std::string> blocks; ///< are "<kind>/<id>", tried in this order
};

/// Compiles each block and draws it once, and calls `tell` before and after each one. A block may
/// crash, hang or exhaust this process.
void tryBlocks(const TrialRequest& request, const std::function<void(const TrialReport&)>& report);

} // namespace patina
