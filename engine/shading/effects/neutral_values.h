// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "catalog/block.h"
#include "material/material.h"

namespace patina {

/// Tells whether a block with these values gives 0 everywhere, so that its code need not be there:
/// by a case that its descriptor declares; a light, a fog or an environment also without a colour,
/// intensity or density, or with a cone that has no angle. Allocates nothing.
bool isNeutral(const Block& block, const Values& values, const AccuracyLevels& levels = {});

/// "It is black.", "Its “Density” is 0.": why isNeutral() holds; empty where it does not.
std::string whyNeutral(const Block& block, const Values& values, const AccuracyLevels& levels = {});

/// Tells whether a block of the material's `kind` is neutral and no image changes any of its
/// values.
bool isNeutralPart(const Block& block, const Values& values, const Material& material);

} // namespace patina
