// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

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
    /// Are nanoseconds per pixel of the model; empty where nobody measured them.
    std::optional<double> nanoseconds;
    /// Says that no other model is both nearer and quicker; all are where no times are known.
    bool isOnFront = true;
    bool isStopped =
        false; ///< says that its fit was ended early, so that a better one may be there
};

struct ModelMatches {
    std::vector<ModelMatch> rows; ///< are sorted by error, the least first
    Errors problems;              ///< say which models could not be fitted
};

/// Returns the models that are reflectances (whyNoReflectance()).
std::vector<const Block*> matchedModels(const Catalog& catalog);

/// Is called about ten times a second, and when a model is done, with how much is done, 0 .. 1, and
/// with what was fitted so far; false ends the work.
using GoesOn = std::function<bool(double done, const ModelMatches& soFar)>;

/// Returns the material that a fit of a model begins with: `own` with that model, and with what the
/// aim's material has that the model takes.
Material matchStart(const Material& own, const MatchAim& aim, const Block& model,
                    const Catalog& catalog);

/// Fits materials to a target, on all cores, beginning with their own values. What was fitted when
/// it is ended is returned. `goesOn` is called on the thread that waits.
ModelMatches fittedMaterials(const std::vector<Material>& materials, const MatchTarget& target,
                             const FitOptions& options, const Catalog& catalog,
                             const GoesOn& goesOn);

/// Gives each match the time of its model, where it was measured, and marks the front.
void addTimes(ModelMatches& matches, const std::map<std::string, double>& nanoseconds);

/// Returns the quickest match whose relative error is at most `within`; null where none is or no
/// times are known.
const ModelMatch* quickestWithin(const ModelMatches& matches, double within);

/// Returns a table, and below it which is the quickest within the relative error.
std::string matchesText(const ModelMatches& matches, double within);
/// Returns one line for each row: model, errors, time, and whether it is on the front.
std::string matchesCsv(const ModelMatches& matches);
nlohmann::json matchesJson(const ModelMatches& matches);

} // namespace patina
