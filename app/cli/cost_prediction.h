// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/cost_request.h"
#include "cli/long_work.h"
#include "core/error.h"

namespace patina {

/// Predicts what the material of each preset, or each model, costs on graphics cards that are not
/// here, and prints it or writes it into the file of a job. Nothing is drawn. The result is true
/// unless a preset of a job failed.
Checked<bool> predictCosts(const CLI::App& command, const CostRequest& options, LongWork& work);

} // namespace patina
