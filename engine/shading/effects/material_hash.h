// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "material/material.h"

namespace patina {

/// Returns a number that is equal for materials that are drawn alike: of everything that the
/// renderer reads of a material, so not of its name or its author. Allocates nothing, and takes a
/// fraction of what it takes to compare or pack the values.
std::uint64_t materialHash(const Material& material);

} // namespace patina
