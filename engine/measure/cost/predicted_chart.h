// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "measure/cost/cost_chart.h"
#include "measure/prediction/predicted_ways.h"

namespace patina {

/// Returns a chart with the errors that were measured and with the times that are predicted for a
/// card, for a picture of `size` pixels that the object fills. A point that was not compiled for
/// the card's family is left out. It is an error where that is so of the exact one.
Result<CostChart> predictedChart(const CostChart& chart, const PredictedPoints& predicted,
                                 const CardOfFamily& card, glm::ivec2 size);

} // namespace patina
