// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "measure/cost/cost_sweep.h"

namespace patina {

/// Returns the pixels of a sweep's frames: those of the options, or what the device of the current
/// context is up to.
glm::ivec2 sweepSize(const CostSweep::Subject& subject, const CostSweep::Options& options);

} // namespace patina
