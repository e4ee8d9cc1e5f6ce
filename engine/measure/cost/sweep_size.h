// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "measure/cost/cost_sweep.h"

namespace patina {

/// Returns the size of a sweep's frames in pixels: that of the options, or, where they have none,
/// one that suits the device of the current context.
glm::ivec2 sweepSize(const CostSweep::Subject& subject, const CostSweep::Options& options);

} // namespace patina
