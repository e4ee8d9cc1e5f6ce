// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "material/material.h"

namespace patina {

/// Returns the blocks whose formulas a material uses, as far as the catalogue knows them: its model
/// first, then what fills the model's slots and what is blended over a model without such a slot.
/// Empty where the model is not known.
std::vector<const Block*> blocksInUse(const Material& material, const Catalog& catalog);

} // namespace patina
