// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include <nlohmann/json.hpp>

#include "measure/prediction/predicted_models.h"
#include "measure/prediction/predicted_ways.h"

namespace patina {

/// Return the ways of a material, or models, as a table with one line for each on each family.
std::string predictionText(std::span<const PredictedWay> ways,
                           std::span<const GpuFamily* const> families);
std::string predictionText(std::span<const PredictedModel> models,
                           std::span<const GpuFamily* const> families);

/// Return the same as an array of JSON.
nlohmann::json predictionJson(std::span<const PredictedWay> ways,
                              std::span<const GpuFamily* const> families);
nlohmann::json predictionJson(std::span<const PredictedModel> models,
                              std::span<const GpuFamily* const> families);

/// Are the ways of one preset, with its name.
struct NamedWays {
    std::string preset;
    std::span<const PredictedWay> ways;
};

/// Return the same as comma-separated values: a line for each card of each family.
std::string predictionCsv(std::span<const NamedWays> presets,
                          std::span<const GpuFamily* const> families);
std::string predictionCsv(std::span<const PredictedModel> models,
                          std::span<const GpuFamily* const> families);

/// Returns "Steam Deck 5.10 ms, Radeon RX 6600 1.42 ms": a stage's time at 1080p on a family's
/// cards.
std::string cardsText(const StageStatistics& stage, const GpuFamily& family);

/// Returns what a stage is on a family as JSON, with the milliseconds on the family's cards.
nlohmann::json stageJson(const StageStatistics& stage, const GpuFamily& family);

/// Says what the numbers are, and what is left out of them.
std::string predictionLegend(const std::string& driver, std::span<const GpuFamily* const> families);

/// Returns the pieces of the legend as JSON: "driver", "leftOut", "cards" with their sources.
nlohmann::json predictionNotes(const std::string& driver,
                               std::span<const GpuFamily* const> families);

} // namespace patina
