// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "measure/cost/cost_chart.h"
#include "scene/scene.h"

namespace patina {

/// Holds a chart and the camera that it was measured from.
struct MeasuredChart {
    Camera camera;
    CostChart chart;
};

} // namespace patina
