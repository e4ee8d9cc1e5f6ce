// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "bundle/preset_bundle.h"

namespace patina {

/// Prints the name of each preset of a bundle that was written, and reports each problem as a
/// mistake in `file`; returns false where there was one.
bool tellOutcomes(const std::vector<BundleOutcome>& outcomes, const std::string& file);

} // namespace patina
