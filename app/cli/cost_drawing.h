// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "cli/plot_shapes.h"
#include "measure/cost/cost_chart.h"

namespace patina {

/// Returns the chart as a drawing of `size` pixels: the time to the right, the error upwards, both
/// on logarithmic scales. Bars show how sure the times are, a line shows the front, and rings mark
/// what may be on it within the noise.
std::vector<PlotShape> costPlot(const CostChart& chart, glm::ivec2 size);

} // namespace patina
