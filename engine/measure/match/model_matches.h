// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "core/progress.h"
#include "material/material.h"
#include "measure/match/match_target.h"
#include "measure/match/model_fit.h"

namespace patina {

/// Holds a material that was fitted to a target.
struct ModelMatch {
    Material material;
    std::string label;     ///< names its model
    double error = 0.0;    ///< is the measure that was made small
    double relative = 0.0; ///< is the root of sum (m - t)^2 / sum t^2
    /// Are nanoseconds per pixel of the model with its defaults; empty where nobody measured them.
    std::optional<double> nanoseconds;
    /// Says that no other model is both nearer and quicker; all are where no times are known.
    bool isOnFront = true;
};

struct ModelMatches {
    std::vector<ModelMatch> rows; ///< are sorted by error, the least first
    Errors problems;              ///< say which models could not be fitted
};

/// Returns the models that are reflectances (whyNoReflectance()).
std::vector<const Block*> matchedModels(const Catalog& catalog);

/// Fits materials to a target, on all cores, beginning with their own values. What was fitted when
/// it is cancelled is returned; `progress` counts materials that are done.
ModelMatches fittedMaterials(const std::vector<Material>& materials, const MatchTarget& target,
                             const FitOptions& options, const Catalog& catalog, Progress& progress);

/// Marks the rows that are on the front of error and time.
void markFront(ModelMatches& matches);

/// Returns the quickest match whose relative error is at most `within`; null where none is or no
/// times are known.
const ModelMatch* quickestWithin(const ModelMatches& matches, double within);

/// Returns a table, and below it which is the quickest within the relative error.
std::string matchesText(const ModelMatches& matches, double within);
nlohmann::json matchesJson(const ModelMatches& matches);

} // namespace patina
