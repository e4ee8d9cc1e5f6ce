// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/job.h"
#include "cli/picture_options.h"
#include "core/error.h"
#include "measure/time/choice_cost.h"
#include "predict/gpu_family.h"

namespace patina {

/// Holds what `patina cost` is asked for.
struct CostRequest {
    std::vector<std::string> presets;
    PictureOptions picture; ///< its size is 0 unless given; it then depends on the device's speed
    std::optional<double> budgetMilliseconds;
    std::optional<double> budgetError;
    bool ofPicture = false;
    bool singles = false;
    bool allModels = false;
    bool scaling = false;
    bool json = false;
    bool csv = false;
    /// Are those that costs are predicted for instead of measured; empty: measured.
    std::vector<const GpuFamily*> families;
    /// Is the one that a chart's times are predicted for; none: they are measured, or --gpu alone
    /// is given.
    std::optional<CardOfFamily> card;
    /// Are the pixels of the picture that they are predicted for; none: those of 1080p.
    std::optional<glm::ivec2> shown;
    bool asItIs = false; ///< predicts no level but those that the material has
    std::string plot;
    std::string errorMap;
    std::string errorMapOf; ///< names levels as levelsText() does; empty where not given
    double seconds = 60.0;
    CostPairs::Options pairs{}; ///< are those of frames for a time
    JobOptions job;

    bool hasBudget() const { return budgetMilliseconds || budgetError; }
    /// Tells whether something is asked for that only a chart of presets has.
    bool hasChartOptions() const {
        return hasBudget() || !plot.empty() || !errorMap.empty() || !errorMapOf.empty() ||
               ofPicture || singles || shown;
    }
    /// Tells whether costs of ways and models are predicted and nothing is drawn.
    bool isPredictedOnly() const { return !families.empty() && !card; }
};

/// Declares all options of the command.
void addCostOptions(CLI::App& command, CostRequest& request);

/// Returns the extension of a file's name in small letters, as ".png" of "Errors.PNG"; empty where
/// it has none.
std::string endingOf(const std::string& file);

/// Takes the middle card of a family for a budget or chart that is asked for with --gpu.
void takeCardOfFamily(CostRequest& request);

/// Returns what is wrong with the request, before anything is measured: options that would have no
/// effect, and files that could not be written afterwards.
Errors checkRequest(const CostRequest& request);

} // namespace patina
