// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/cost_request.h"
#include "cli/long_work.h"
#include "core/error.h"

namespace patina {

/// Predicts what the material of each preset, or each model, costs on graphics cards that are not
/// here, and prints it. Nothing is drawn. The result is true.
Checked<bool> predictCosts(const CostRequest& options, const LongWork& work);

} // namespace patina
