// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "bundle/preset_bundle.h"

namespace patina {

/// Prints what was done for each preset of a bundle, and reports the rest as mistakes in `file`;
/// false where anything was not done.
bool tellOutcomes(const std::vector<BundleOutcome>& outcomes, const std::string& file);

} // namespace patina
