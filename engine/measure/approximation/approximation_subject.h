// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "material/material.h"
#include "measure/eval/eval_case.h"

namespace patina {

/// Returns a block with its defaults, and what fills its slot then, for the first of its functions
/// that a case can hold. It is an error where there is none.
Checked<EvalCase> defaultCase(const Catalog& catalog, const Block& block);

/// Returns a block that a material uses (blocksInUse()) with the material's values, and with every
/// accuracy choice exact. It is an error where a block that it needs is not known or cannot be
/// evaluated by itself.
Checked<EvalCase> caseInMaterial(const Catalog& catalog, const Material& material,
                                 const Block& block);

} // namespace patina
