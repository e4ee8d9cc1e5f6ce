// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "trial/trial_report.h"

namespace patina {

/// Holds what a process is asked to try.
struct TrialRequest {
    std::filesystem::path shaders;   ///< the blocks that ship
    std::filesystem::path own;       ///< the user's
    std::vector<std::string> blocks; ///< "<kind>/<id>", in this order
};

/// Compiles each block and draws it once, with whatever that does to this process, and tells before
/// and after each one.
void tryBlocks(const TrialRequest& request, const std::function<void(const TrialReport&)>& tell);

} // namespace patina
