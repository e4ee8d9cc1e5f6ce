// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "measure/cost/cost_chart.h"
#include "measure/prediction/predicted_ways.h"
#include "scene/scene.h"

namespace patina {

/// Holds a chart, the camera that it was measured from, and what its ways would cost on graphics
/// cards that are not here.
struct MeasuredChart {
    Camera camera;
    CostChart chart;
    Result<PredictedPoints> predicted; ///< has no ways where nobody asked
};

} // namespace patina
