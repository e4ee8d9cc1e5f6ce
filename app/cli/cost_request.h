// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/picture_options.h"
#include "core/error.h"

namespace patina {

/// Holds what `patina cost` is asked for.
struct CostRequest {
    std::vector<std::string> presets;
    PictureOptions picture; ///< its size is 0 unless given: as the machine is up to
    std::optional<double> budgetMilliseconds;
    std::optional<double> budgetError;
    bool ofPicture = false;
    bool singles = false;
    bool allModels = false;
    bool scaling = false;
    bool json = false;
    bool csv = false;
    std::string plot;
    std::string errorMap;
    std::string errorMapOf; ///< as levelsText() names a way; empty: not given
    double seconds = 60.0;

    bool hasBudget() const { return budgetMilliseconds || budgetError; }
};

/// Declares all options of the command.
void addCostOptions(CLI::App& command, CostRequest& request);

/// ".png" of "Errors.PNG"; empty where a name has none.
std::string endingOf(const std::string& file);

/// Returns what is wrong with the request, before anything is measured: what would be left out
/// silently and what could not be written afterwards are mistakes.
Errors checkRequest(const CostRequest& request);

} // namespace patina
