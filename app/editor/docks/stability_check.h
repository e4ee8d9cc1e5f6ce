// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "background/worker.h"
#include "catalog/catalog.h"
#include "docks/stability_outcome.h"
#include "material/material.h"

namespace patina {

/// Evaluates a material in the edge cases of its formulas, on the GPU and in double precision. It
/// runs as work of a Worker, and reports the share done and the number of cases. Cancelling keeps
/// what was found.
StabilityOutcome checkStability(const Catalog& catalog, const Material& material,
                                Worker::Control& control);

} // namespace patina
