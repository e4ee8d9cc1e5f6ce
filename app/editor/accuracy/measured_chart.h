// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "measure/cost/cost_chart.h"
#include "scene/scene.h"

namespace patina {

/// A chart, and from where it was measured.
struct MeasuredChart {
    Camera camera;
    CostChart chart;
};

} // namespace patina
