// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "cli/cost_request.h"
#include "cli/long_work.h"
#include "measure/cost/model_ranking.h"
#include "measure/cost/scaling_curve.h"

namespace patina {

/// Holds a chart, and the errors of one of its points per pixel.
struct Sweep {
    CostChart chart;
    ChosenLevels mapped;
    /// Holds what CostSweep::errorMap() returns; empty where no map is asked for.
    std::vector<double> errors;
};

/// Returns what `patina cost` measures; a context has to be current. Work that is stopped ends with
/// what it has, or with an error where it has nothing.
Checked<Sweep> swept(CostSweep::Subject subject, const CostRequest& options, LongWork& work);
Checked<std::vector<ScalingCurve>> scaled(CostSweep::Subject subject, const CostRequest& options,
                                          LongWork& work);
/// Ranks these materials.
Checked<std::vector<ModelCost>> ranked(CostSweep::Subject subject, const CostRequest& options,
                                       LongWork& work, std::vector<Material> materials);
/// Ranks all models with their defaults.
Checked<std::vector<ModelCost>> rankedModels(CostSweep::Subject subject, const CostRequest& options,
                                             LongWork& work);

} // namespace patina
