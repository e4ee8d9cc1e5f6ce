// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "cli/cost_request.h"
#include "cli/long_work.h"
#include "measure/cost/model_ranking.h"
#include "measure/cost/scaling_curve.h"

namespace patina {

/// A chart, and where one of its points goes wrong.
struct Sweep {
    CostChart chart;
    ChosenLevels mapped;
    std::vector<double> errors; ///< as CostSweep::errorMap(); empty where it is not asked for
};

/// Returns what `patina cost` measures, with a context current. Work that is stopped ends with what
/// it has, or with an error where it has nothing.
Checked<Sweep> swept(CostSweep::Subject subject, const CostRequest& options, LongWork& work);
Checked<std::vector<ScalingCurve>> scaled(CostSweep::Subject subject, const CostRequest& options,
                                          LongWork& work);
Checked<std::vector<ModelCost>> ranked(CostSweep::Subject subject, const CostRequest& options,
                                       LongWork& work);

} // namespace patina
