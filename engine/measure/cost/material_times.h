// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "measure/cost/cost_sweep.h"

namespace patina {

/// Is the time of a material on an object.
struct MaterialTime {
    double nanoseconds = 0.0;  ///< per shaded pixel, without the empty frame's time
    bool isBelowNoise = false; ///< says that it cannot be told from the empty frame's
};

/// Measures the materials on the subject's object as the accuracy charts measure levels: pairs of
/// frames, the first material's and another's, and frames without the object. `isWanted` is asked
/// before each pair. It is an error where frames cannot be drawn, where none of the object's pixels
/// are seen, and where it is no longer wanted. A context must be current.
Result<std::vector<MaterialTime>> materialTimes(
    const CostSweep::Subject& subject, const std::vector<Material>& materials,
    const CostSweep::Options& options, const std::function<bool()>& isWanted = [] { return true; });

} // namespace patina
