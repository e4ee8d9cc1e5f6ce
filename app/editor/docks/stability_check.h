// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "background/worker.h"
#include "catalog/catalog.h"
#include "docks/stability_outcome.h"
#include "material/material.h"

namespace patina {

/// Evaluates a material wherever formulas break, on the graphics device and in double precision:
/// work of a Worker, which tells the share that is done and how many cases that are.
StabilityOutcome checkStability(const Catalog& catalog, const Material& material,
                                Worker::Control& control);

} // namespace patina
