// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "accuracy/kept_results.h"
#include "measure/cost/cost_chart.h"

namespace patina {

/// A chart, perhaps of a measurement that has not ended.
struct KeptChart {
    MeasuredSubject subject;
    std::string file; ///< of the document; empty: it has none yet
    Camera camera;    ///< where it was measured from
    CostChart chart;
    bool complete = false;
    std::string problem; ///< why it ended before its time; else empty
};

} // namespace patina
